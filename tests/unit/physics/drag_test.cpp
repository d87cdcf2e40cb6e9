// Drag: the medium takes velocity at a constant relative rate, whatever the mass.
#include "catch.h"
#include "lab.h"

using namespace morula;

TEST_CASE("Drag is −drag · m · v on each vertex") {
  PhysicsParameters p = softCell();
  p.membrane = {0, 0, 1};
  p.drag = 0.25;
  const Mesh mesh = makeIcosphere(1);
  Body light = shakenBody(mesh, 0, 2), heavy = shakenBody(mesh, 0, 2, 1);
  heavy.mass = 42;
  const Lab lab = evaluated({p, mesh, {light, heavy}});
  Worst error;
  for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
    error.see(norm(lab.force(0, v) + (0.25 / 42) * light.velocity[v]));
    error.see(norm(lab.force(1, v) + 0.25 * heavy.velocity[v]));
  }
  CHECK(error < 1e-15);
}

TEST_CASE("A body that only drag acts on slows down exponentially, to second order") {
  PhysicsParameters p = softCell();
  p.drag = 0.5;
  const Mesh mesh = makeIcosphere(1);
  const auto errorWith = [&](int steps) {
    Body body = shakenBody(mesh, 0, 0);
    for (Vector& u : body.velocity) u = {3, -2, 1};
    const Lab lab = stepped({p, mesh, {body}}, steps, 2.0 / steps);
    const double share = lab.velocity(0, 7).x / 3;
    CHECK(norm(lab.velocity(0, 7) - share * Vector{3, -2, 1}) < 1e-12);
    // The body has moved by (1 − 1/e) times its velocity over the drag rate.
    CHECK(lab.bodies.vertex(0, 7).x - mesh.vertices[7].x == Approx(3 * (1 - std::exp(-1.0)) / 0.5).epsilon(0.01));
    return std::abs(share - std::exp(-1.0));
  };
  CHECK(errorWith(256) / errorWith(512) == Approx(4).margin(0.2));
}

TEST_CASE("Without drag nothing slows down") {
  const Mesh mesh = makeIcosphere(1);
  Body body = shakenBody(mesh, 0, 0);
  for (Vector& u : body.velocity) u = {3, -2, 1};
  const Lab lab = stepped({softCell(), mesh, {body}}, 512, 0x1p-8);
  CHECK(norm(lab.velocity(0, 7) - Vector{3, -2, 1}) < 1e-10);
}
