// A shell holds every vertex, or every surface below a vertex: held points slide, others are left alone. Tests of held
// surfaces alone: shell_surface_test.cpp.
#include "catch.h"
#include "round_shell.h"

using namespace morula;

namespace {

/// Returns round shells that hold vertices and round shells that hold surfaces.
std::vector<ShellParameters> allRoundShells() {
  std::vector<ShellParameters> shells = roundShells(Held::vertices);
  for (const ShellParameters& shell : roundShells(Held::surface)) shells.push_back(shell);
  return shells;
}

/// Returns physics in the shell without springs, so that only a test's own forces act.
PhysicsParameters slackIn(const ShellParameters& shell) {
  PhysicsParameters p = inShell(shell);
  p.membrane = {0, 0, 1};
  return p;
}

}  // namespace

TEST_CASE("Every point that is held is inside to 1e-12 after every step, however hard it is pushed") {
  for (const ShellParameters& shell : allRoundShells()) {
    const double* a = shell.semiAxes.data();
    PhysicsParameters p = inShell(shell);
    p.pressure.constant = 100 * a[0] * a[1] * a[2];
    const Mesh mesh = zoo::scaled(makeIcosphere(2), {0.95 * a[0], 0.95 * a[1], 0.95 * a[2]});
    for (Integrator integrator : {Integrator::velocityVerlet, Integrator::thesisVerlet}) {
      p.integrator = integrator;
      Body body = shakenBody(mesh, 0, 20 * a[0]);
      body.pressureConstant = p.pressure.constant;
      Lab lab(p, mesh, {body});
      lab.start();
      Worst farthest;
      int touching = 0;
      for (int i = 0; i < 500; ++i) {
        lab.step(0x1p-11);
        for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
          const double reach = quadric(lab.bodies.vertex(0, v), felt(lab.bodies));
          farthest.see(reach);
          touching += reach > 1 - 1e-12;
        }
      }
      CAPTURE(nameOf(shell.holds), a[0]);
      CHECK(farthest <= 1 + 1e-12);
      CHECK(touching > 100);
    }
  }
}

TEST_CASE("A vertex outside is put on the shell, almost at its nearest point") {
  for (const ShellParameters& shell : roundShells(Held::vertices)) {
    const double* a = shell.semiAxes.data();
    const Mesh mesh = makeIcosphere(2);
    for (double excess : {1e-9, 1e-3, 0.02}) {
      Lab lab(inShell(shell), mesh, {shakenBody(mesh, 0, 0)});
      std::vector<Point> before;
      for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
        const Point onShell{a[0] * mesh.vertices[v].x, a[1] * mesh.vertices[v].y, a[2] * mesh.vertices[v].z};
        before.push_back(onShell + excess * a[2] * outward(onShell, shell));
        lab.setPosition(0, v, before.back());
      }
      lab.evaluate();
      Worst off, away;
      for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
        const Point x = lab.bodies.vertex(0, v);
        off.see(std::abs(quadric(x, shell) - 1));
        away.see(norm(x - nearestOnShell(before[v], shell)) / a[0]);
      }
      CHECK(off <= 1e-15);
      CHECK(away <= 1e-14 + 0.25 * excess * excess);  // scaling alone would give 0.3 excess
    }
  }
}

TEST_CASE("What is on the shell slides: its outward velocity is lost and the rest is kept") {
  for (const ShellParameters& shell : allRoundShells()) {
    const double* a = shell.semiAxes.data();
    const Mesh mesh = makeIcosphere(2);
    Body body = shakenBody(mesh, 0, 1);
    for (Point& x : body.position) x = {1.1 * a[0] * x.x, 1.1 * a[1] * x.y, 1.1 * a[2] * x.z};
    Lab lab = evaluated({slackIn(shell), mesh, {body}});
    Worst error, outwardForce;
    int kept = 0, lost = 0;
    for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
      const Vector n = outward(lab.bodies.vertex(0, v), felt(lab.bodies)), u = body.velocity[v];
      error.see(norm(lab.velocity(0, v) - (u - std::max(0.0, dot(u, n)) * n)));
      ++(dot(u, n) > 0 ? lost : kept);
    }
    lab.endEvaluation();
    for (int v = 0; v < lab.bodies.vertexCount(); ++v)
      outwardForce.see(dot(lab.force(0, v), outward(lab.bodies.vertex(0, v), felt(lab.bodies))));
    CAPTURE(nameOf(shell.holds), a[0]);
    CHECK(error < 1e-14);
    CHECK(outwardForce < 1e-14);
    CHECK(kept > 20);
    CHECK(lost > 20);
  }
}

TEST_CASE("The shell bears the outward force and leaves the rest") {
  for (const ShellParameters& shell : allRoundShells()) {
    const double* a = shell.semiAxes.data();
    PhysicsParameters p = slackIn(shell);
    const Mesh mesh = makeIcosphere(2);
    const Body body = shakenBody(zoo::scaled(mesh, {1.1 * a[0], 1.1 * a[1], 1.1 * a[2]}), 0, 0);
    Lab held = evaluated({p, mesh, {body}});
    p.shell.reset();
    Lab free = evaluated({p, mesh, {body}});
    // Random forces push about half of the vertices out, and half in.
    for (Lab* lab : {&held, &free}) {
      Bodies& b = lab->bodies;
      for (int v = 0; v < b.vertexCount(); ++v)
        b.write(b.acceleration, 0, v, noiseVector(static_cast<std::uint32_t>(v), 5));
      lab->endEvaluation();
    }
    Worst error;
    int borne = 0;
    for (int v = 0; v < held.bodies.vertexCount(); ++v) {
      const Vector n = outward(held.bodies.vertex(0, v), felt(held.bodies)), f = free.force(0, v);
      error.see(norm(held.force(0, v) - (f - std::max(0.0, dot(f, n)) * n)) / norm(f));
      borne += dot(f, n) > 0;
    }
    CAPTURE(nameOf(shell.holds), a[0]);
    CHECK(error < 1e-14);
    CHECK(borne > 40);
    CHECK(borne < 120);
  }
}

TEST_CASE("What has hit the shell has no outward velocity for drag and damping to see") {
  for (const Held holds : {Held::vertices, Held::surface}) {
    PhysicsParameters p = slackIn({{1, 1, 1}, {}, holds});
    p.drag = 2;
    const Mesh mesh = makeIcosphere(2);
    Body body = shakenBody(zoo::scaled(mesh, {1.1, 1.1, 1.1}), 0, 0);
    for (std::size_t v = 0; v < body.position.size(); ++v) body.velocity[v] = 3.0 * mesh.vertices[v];
    CHECK(largestForce(evaluated({p, mesh, {body}})) < 1e-14);
  }
}

TEST_CASE("A vertex shot along the shell goes round it and keeps its speed") {
  const Mesh mesh = makeIcosphere(1);
  Body body = shakenBody(mesh, 0, 0);
  const Point start = body.position[5];
  const Vector along = cross(start, Vector{0, 0, 1});
  body.velocity[5] = along / norm(along);
  const Lab lab = stepped({slackIn({{1, 1, 1}, {}, Held::vertices}), mesh, {body}}, 4096, 0x1p-10);
  CHECK(norm(lab.bodies.vertex(0, 5)) == Approx(1).epsilon(1e-14));
  CHECK(norm(lab.velocity(0, 5)) == Approx(1).epsilon(0.01));
  CHECK(dot(lab.bodies.vertex(0, 5), start) == Approx(std::cos(4.0)).margin(0.02));
}

TEST_CASE("Nothing happens to cells inside: the same bits with and without a shell, whatever it holds") {
  const Mesh mesh = zoo::crumpled(makeIcosphere(2), 0.1, 2);
  for (const Held holds : {Held::vertices, Held::surface})
    for (const ShellParameters& shell :
         {ShellParameters{{1.5, 1.5, 1.5}, {}, holds}, ShellParameters{{1.5, 1.6, 1.7}, {}, holds}}) {
      const Lab free = stepped({softCell(), mesh, {shakenBody(mesh, 0, 0.2)}}, 200, 0x1p-9);
      const Lab held = stepped({inShell(shell), mesh, {shakenBody(mesh, 0, 0.2)}}, 200, 0x1p-9);
      CHECK(free.bodies.position == held.bodies.position);
      CHECK(free.bodies.velocity == held.bodies.velocity);
      CHECK(free.bodies.acceleration == held.bodies.acceleration);
    }
}

TEST_CASE("A cell blown up in a shell comes to rest on it, with its vertices or its surface") {
  for (const Held holds : {Held::vertices, Held::surface}) {
    PhysicsParameters p = inShell({{1, 1, 1}, {}, holds});
    p.pressure.constant = 400;
    p.drag = 4;
    p.membrane.damping = 0.5;
    const Lab lab = stepped({p, zoo::scaled(makeIcosphere(2), {0.9, 0.9, 0.9})}, 8192, 0x1p-9);
    int onShell = 0;
    for (int v = 0; v < lab.bodies.vertexCount(); ++v)
      onShell += quadric(lab.bodies.vertex(0, v), felt(lab.bodies)) > 1 - 1e-12;
    CAPTURE(nameOf(holds));
    CHECK(fastestVertex(lab.bodies) < 1e-6);
    CHECK(onShell == lab.bodies.vertexCount());
  }
}
