// A shell that holds vertices holds every one, lets it slide, and leaves the others alone. Where it holds surfaces:
// shell_surface_test.cpp.
#include "catch.h"
#include "lab.h"
#include "round_shell.h"

using namespace morula;

namespace {

PhysicsParameters inShell(double a, double b, double c) {
  PhysicsParameters p = softCell();
  p.shell = ShellParameters{{a, b, c}, {}, Held::vertices};
  return p;
}

const std::vector<ShellParameters> shells{{{1, 1, 1}}, {{2.5, 2.5, 2.5}}, {{1.25, 1, 0.8}}, {{27, 15, 11}}};

}  // namespace

TEST_CASE("Every vertex is inside to 1e-12 after every step, however hard it is pushed") {
  for (const ShellParameters& shell : shells) {
    const double* a = shell.semiAxes;
    PhysicsParameters p = inShell(a[0], a[1], a[2]);
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
        for (const Point& x : lab.positions()) {
          farthest.see(quadric(x, shell));
          touching += quadric(x, shell) > 1 - 1e-12;
        }
      }
      CHECK(farthest <= 1 + 1e-12);
      CHECK(touching > 100);
    }
  }
}

TEST_CASE("A vertex outside is put on the shell, almost at its nearest point") {
  for (const ShellParameters& shell : shells) {
    const double* a = shell.semiAxes;
    const Mesh mesh = makeIcosphere(2);
    for (double excess : {1e-9, 1e-3, 0.02}) {
      Lab lab(inShell(a[0], a[1], a[2]), mesh, {shakenBody(mesh, 0, 0)});
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
      CHECK(away <= 1e-14 + 0.25 * excess * excess);  // the scaling alone: 0.3 excess
    }
  }
}

TEST_CASE("A vertex on the shell slides: its outward velocity is lost and the rest is kept") {
  for (const ShellParameters& shell : shells) {
    const double* a = shell.semiAxes;
    PhysicsParameters p = inShell(a[0], a[1], a[2]);
    p.membrane = {0, 0, 1};
    const Mesh mesh = makeIcosphere(2);
    Body body = shakenBody(mesh, 0, 1);
    for (Point& x : body.position) x = {1.001 * a[0] * x.x, 1.001 * a[1] * x.y, 1.001 * a[2] * x.z};
    Lab lab(p, mesh, {body});
    lab.start();
    Worst error, outwardForce;
    int kept = 0, lost = 0;
    for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
      const Vector n = outward(lab.bodies.vertex(0, v), shell), u = body.velocity[v];
      error.see(norm(lab.velocity(0, v) - (u - std::max(0.0, dot(u, n)) * n)));
      outwardForce.see(dot(lab.force(0, v), n));
      ++(dot(u, n) > 0 ? lost : kept);
    }
    CHECK(error < 1e-14);
    CHECK(outwardForce < 1e-14);
    CHECK(kept > 20);
    CHECK(lost > 20);
  }
}

TEST_CASE("The shell bears the outward force and leaves the rest") {
  for (const ShellParameters& shell : shells) {
    const double* a = shell.semiAxes;
    PhysicsParameters p = inShell(a[0], a[1], a[2]);
    p.membrane = {0, 0, 1};
    const Mesh mesh = makeIcosphere(2);
    Body body = shakenBody(zoo::scaled(mesh, {a[0], a[1], a[2]}), 0, 0);
    Lab held(p, mesh, {body});
    p.shell.reset();
    Lab free(p, mesh, {body});
    // Forces of two kinds, set by hand: half of the vertices are pushed out, half in.
    Worst error;
    int borne = 0;
    held.evaluate();
    free.evaluate();
    for (Lab* lab : {&held, &free})
      for (int v = 0; v < lab->bodies.vertexCount(); ++v) {
        Bodies& b = lab->bodies;
        b.write(b.acceleration, 0, v, noiseVector(static_cast<std::uint32_t>(v), 5));
      }
    held.endEvaluation();
    free.endEvaluation();
    for (int v = 0; v < held.bodies.vertexCount(); ++v) {
      const Vector n = outward(held.bodies.vertex(0, v), shell), f = free.force(0, v);
      error.see(norm(held.force(0, v) - (f - std::max(0.0, dot(f, n)) * n)) / norm(f));
      borne += dot(f, n) > 0;
    }
    CHECK(error < 1e-14);
    CHECK(borne > 40);
    CHECK(borne < 120);
  }
}

TEST_CASE("A vertex that has hit the shell has no outward velocity for drag and damping to see") {
  PhysicsParameters p = inShell(1, 1, 1);
  p.membrane = {0, 0, 1};
  p.drag = 2;
  const Mesh mesh = makeIcosphere(2);
  Body body = shakenBody(zoo::scaled(mesh, {1.001, 1.001, 1.001}), 0, 0);
  for (std::size_t v = 0; v < body.position.size(); ++v) body.velocity[v] = 3.0 * mesh.vertices[v];
  Lab lab(p, mesh, {body});
  lab.evaluate();
  Worst force;
  for (int v = 0; v < lab.bodies.vertexCount(); ++v) force.see(norm(lab.force(0, v)));
  CHECK(force < 1e-14);
}

TEST_CASE("A vertex shot along the shell goes round it and keeps its speed") {
  PhysicsParameters p = inShell(1, 1, 1);
  p.membrane = {0, 0, 1};
  const Mesh mesh = makeIcosphere(1);
  Body body = shakenBody(mesh, 0, 0);
  const Point start = body.position[5];
  const Vector along = cross(start, Vector{0, 0, 1});
  body.velocity[5] = along / norm(along);
  Lab lab(p, mesh, {body});
  lab.start();
  for (int i = 0; i < 4096; ++i) lab.step(0x1p-10);
  CHECK(norm(lab.bodies.vertex(0, 5)) == Approx(1).epsilon(1e-14));
  CHECK(norm(lab.velocity(0, 5)) == Approx(1).epsilon(0.01));
  CHECK(dot(lab.bodies.vertex(0, 5), start) == Approx(std::cos(4.0)).margin(0.02));
}

TEST_CASE("Nothing happens to cells inside: the same bits with and without a shell, whatever it holds") {
  const Mesh mesh = zoo::crumpled(makeIcosphere(2), 0.1, 2);
  for (const ShellParameters& shell :
       {ShellParameters{{1.5, 1.5, 1.5}, {}, Held::vertices}, ShellParameters{{1.5, 1.6, 1.7}, {}, Held::vertices},
        ShellParameters{{1.5, 1.5, 1.5}, {}, Held::surface}, ShellParameters{{1.5, 1.6, 1.7}, {}, Held::surface}}) {
    PhysicsParameters p = softCell();
    Lab free(p, mesh, {shakenBody(mesh, 0, 0.2)});
    p.shell = shell;
    Lab held(p, mesh, {shakenBody(mesh, 0, 0.2)});
    free.start();
    held.start();
    for (int i = 0; i < 200; ++i) {
      free.step(0x1p-9);
      held.step(0x1p-9);
    }
    CHECK(free.bodies.position == held.bodies.position);
    CHECK(free.bodies.velocity == held.bodies.velocity);
    CHECK(free.bodies.acceleration == held.bodies.acceleration);
  }
}

TEST_CASE("A cell blown up in a shell comes to rest on it, with its vertices or its surface") {
  for (const Held holds : {Held::vertices, Held::surface}) {
    PhysicsParameters p = inShell(1, 1, 1);
    p.shell->holds = holds;
    p.pressure.constant = 400;
    p.drag = 4;
    p.membrane.damping = 0.5;
    Lab lab(p, zoo::scaled(makeIcosphere(2), {0.9, 0.9, 0.9}));
    lab.start();
    for (int i = 0; i < 8192; ++i) lab.step(0x1p-9);
    Worst fastest;
    int onShell = 0;
    for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
      fastest.see(norm(lab.velocity(0, v)));
      const Point point = holds == Held::surface ? lab.bodies.read(lab.bodies.held, 0, v) : lab.bodies.vertex(0, v);
      onShell += norm(point) > 1 - 1e-12;
    }
    CAPTURE(nameOf(holds));
    CHECK(fastest < 1e-6);
    CHECK(onShell == lab.bodies.vertexCount());
  }
}
