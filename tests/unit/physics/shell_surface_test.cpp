// A shell that holds surfaces: it holds what lies below the vertices, lets it slide, and leaves the others alone.
#include "physics/shell_surface.h"

#include <numbers>

#include "catch.h"
#include "physics/integrator.h"
#include "round_shell.h"

using namespace morula;

namespace {

/// δ ŝ of each vertex of a closed mesh by its definition: how far the shell bends away along the edges of the ring.
std::vector<Vector> sagsOf(const Mesh& mesh, const ShellParameters& shell) {
  const double* a = shell.semiAxes;
  std::vector<double> sums(mesh.vertices.size()), counts(mesh.vertices.size());
  for (const Face& f : mesh.faces)
    for (int k = 0; k < 3; ++k) {
      const Vector d = mesh.vertices[f[(k + 1) % 3]] - mesh.vertices[f[k]];
      sums[f[k]] += d.x * d.x / (a[0] * a[0]) + d.y * d.y / (a[1] * a[1]) + d.z * d.z / (a[2] * a[2]);
      counts[f[k]] += 1;
    }
  std::vector<Vector> sags;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const Point& x = mesh.vertices[v];
    const double slope = norm(Vector{x.x / (a[0] * a[0]), x.y / (a[1] * a[1]), x.z / (a[2] * a[2])});
    sags.push_back((sums[v] / counts[v] / (8 * slope)) * outward(x, shell));
  }
  return sags;
}

}  // namespace

TEST_CASE("What is outside is put on the shell, almost at its nearest point, and takes its vertex with it") {
  for (const ShellParameters& shell : roundShells(Held::surface)) {
    const double* a = shell.semiAxes;
    const Mesh mesh = makeIcosphere(2);
    for (double excess : {0.01, 0.02, 0.04}) {
      Lab lab(inShell(shell), mesh, {shakenBody(mesh, 0, 0)});
      Mesh before = mesh;
      for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
        const Point onShell{a[0] * mesh.vertices[v].x, a[1] * mesh.vertices[v].y, a[2] * mesh.vertices[v].z};
        before.vertices[v] = onShell + excess * a[2] * outward(onShell, shell);
        lab.setPosition(0, v, before.vertices[v]);
      }
      const std::vector<Vector> sags = sagsOf(before, shell);
      lab.evaluate();
      Worst off, away, apart;
      int outside = 0;
      for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
        const Point x = lab.bodies.vertex(0, v), y = heldAt(lab.bodies, v);
        const Vector sag = sags[v];
        const Point surface = before.vertices[v] - sag;
        const double beyond = quadric(surface, shell) - 1;
        if (beyond <= 0) {
          CHECK(x == before.vertices[v]);
          continue;
        }
        ++outside;
        apart.see(norm(x - y - sag) / a[0]);
        off.see(std::abs(quadric(y, shell) - 1));
        away.see(norm(y - nearestOnShell(surface, shell)) / a[0]);
      }
      CHECK(apart <= 1e-13);
      CHECK(off <= 1e-14);
      CHECK(away <= 1e-14 + 0.25 * excess * excess);  // the scaling alone: 0.3 excess
      CHECK((excess > 0.03) <= (outside > 40));
    }
  }
}

TEST_CASE("A mesh in a sphere that it fills sags by l²/8R, and holds the sphere's volume to fourth order") {
  // Closed form: edges of length l with both ends at R + δ leave the volume of a ball of radius R.
  double before = 0;
  for (int level : {1, 2, 3, 4}) {
    const ShellParameters unit{{1, 1, 1}, {}, Held::surface};
    Mesh mesh = makeIcosphere(level);
    for (int turn = 0; turn < 60; ++turn) {  // until every held point lies on the shell
      const std::vector<Vector> sags = sagsOf(mesh, unit);
      for (std::size_t v = 0; v < sags.size(); ++v) {
        const Point held = mesh.vertices[v] - sags[v];
        mesh.vertices[v] += (1 / norm(held) - 1) * held;
      }
    }
    for (const Point& held : measureHeldPoints(mesh, unit)) CHECK(norm(held) == Approx(1).epsilon(1e-12));
    const double missing = std::abs(measureVolume(mesh.vertices, mesh.faces) / (4 * std::numbers::pi / 3) - 1);
    CHECK(missing < 0.01 * std::pow(10.0, 1 - level));
    if (before > 0) CHECK(std::log2(before / missing) > 3);
    before = missing;
  }
}

TEST_CASE("A vertex shot along the shell follows it and keeps its speed") {
  PhysicsParameters p = inShell({{1, 1, 1}, {}, Held::surface});
  p.membrane = {0, 0, 1};
  const Mesh mesh = makeIcosphere(1);
  Body body = shakenBody(zoo::scaled(mesh, {1.1, 1.1, 1.1}), 0, 0);
  const Vector along = cross(mesh.vertices[5], Vector{0, 0, 1});
  body.velocity[5] = along / norm(along);
  const Lab lab = stepped({p, mesh, {body}}, 256, 0x1p-10);
  const Point y = heldAt(lab.bodies, 5), x = lab.bodies.vertex(0, 5);
  CHECK(norm(y) <= 1 + 1e-13);  // as its edges get longer there is more and more room for it
  CHECK(norm(y) > 0.999);
  CHECK(norm(lab.velocity(0, 5)) == Approx(1).epsilon(0.01));
  CHECK(dot(x, mesh.vertices[5]) / norm(x) / norm(mesh.vertices[5]) == Approx(std::cos(0.25 / norm(x))).margin(2e-3));
}

namespace {

/// A cell of the ball's volume, at rest in a sphere that is 0.03 larger.
PhysicsParameters pressed() {
  PhysicsParameters p = inShell({{1.03, 1.03, 1.03}, {}, Held::surface});
  p.membrane = {10, 0.02, 1.26, Springs::equal};
  p.pressure = {800, 166};
  p.drag = 8;
  return p;
}

}  // namespace

TEST_CASE("A cell pressed together by a sphere has the sphere's volume, to third order in the mesh's edges") {
  // k_p/V − P_0 = 8.779 of the ball of radius 1.03; held vertices would give 34.1, 14.9 and 10.3.
  const double exact = 800 / (4 * std::numbers::pi / 3 * 1.03 * 1.03 * 1.03) - 166;
  double before = 0;
  for (int level : {1, 2, 3}) {
    const Lab lab = stepped({pressed(), scaleToRadius(makeIcosphere(level), 1)}, 2048 >> (level == 1),
                            level == 3 ? 0x1p-9 : 0x1p-8);
    const double off = lab.bodies.pressure[0] / exact - 1;
    CHECK(off > 0);
    CHECK(off < (level == 1 ? 0.1 : level == 2 ? 0.01 : 0.0015));
    if (before > 0) CHECK(std::log2(before / off) > 2.8);
    before = off;
    CHECK(fastestVertex(lab.bodies) < 1e-9);  // rest is rest
  }
}

TEST_CASE("All integrators, instruction sets and precisions hold surfaces") {
  const auto press = [](Integrator integrator, Isa isa, Precision precision) {
    PhysicsParameters p = pressed();
    p.integrator = integrator;
    p.precision = precision;
    const bool slow = kindOf(integrator).solvesForces || kindOf(integrator).needsDrag;
    const double timeStep = slow ? 0x1p-11 : 0x1p-8;
    return stepped({p, scaleToRadius(makeIcosphere(2), 1), isa}, static_cast<int>(4 / timeStep), timeStep)
        .bodies.pressure[0];
  };
  const double verlet = press(Integrator::velocityVerlet, Isa::scalar, Precision::binary64);
  CHECK(verlet == Approx(8.8529).epsilon(1e-4));
  for (const auto& [integrator, word, meaning] : choices<Integrator>) {
    CAPTURE(word);
    CHECK(press(integrator, Isa::scalar, Precision::binary64) == Approx(verlet).epsilon(0.005));
  }
  for (const Isa isa : availableIsas()) CHECK(press(Integrator::velocityVerlet, isa, Precision::binary64) == verlet);
  CHECK(press(Integrator::velocityVerlet, Isa::scalar, Precision::binary32) == Approx(verlet).epsilon(1e-3));
}
