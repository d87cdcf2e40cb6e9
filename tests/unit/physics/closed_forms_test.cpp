// Motions that have a formula: free flight, a ringing sphere, and Laplace's law of a sphere under pressure.
#include <numbers>

#include "base/maths.h"
#include "catch.h"
#include "lab.h"

using namespace morula;

TEST_CASE("A body at rest in itself flies straight on, at its speed, with every integrator") {
  const Mesh mesh = makeIcosphere(1);
  const Vector velocity{3, -2, 1};
  for (Integrator integrator : {Integrator::velocityVerlet, Integrator::thesisVerlet, Integrator::explicitEuler,
                                Integrator::symplecticEuler, Integrator::rungeKutta4, Integrator::xpbd}) {
    PhysicsParameters p = softCell();
    p.integrator = integrator;
    p.pressure = {0, 0};
    Body body = shakenBody(mesh, 0, 0);
    for (Vector& u : body.velocity) u = velocity;
    const Lab lab = stepped({p, mesh, {body}}, 4096, 0x1p-11);
    Worst off;
    for (int v = 0; v < lab.bodies.vertexCount(); ++v)
      off.see(norm(lab.bodies.vertex(0, v) - (mesh.vertices[v] + 2.0 * velocity)));
    CAPTURE(static_cast<int>(integrator));
    CHECK(off < 1e-10);
  }
}

TEST_CASE("An icosahedron rings and dies away as the linearised sphere says") {
  // All vertices are alike, so the shape stays similar: L = λ L0, V = λ³ V0, T = ½ m λ'². With P0 = k_p/V0 the cell
  // rests at λ = 1, where E = ½ k_s S (λ − 1)² − k_p ln V + P0 V, S = Σ L0², has the curvature E'' = k_s S + 9 k_p. The
  // damping is k_d S + drag m: λ − 1 ∝ e^(−γt/2) cos(Ωt + φ), ω² = E''/m, γ = damping/m, Ω² = ω² − γ²/4.
  const Mesh mesh = makeIcosphere(0);
  for (Integrator integrator : {Integrator::velocityVerlet, Integrator::rungeKutta4}) {
    PhysicsParameters p = softCell();
    p.integrator = integrator;
    p.membrane = {10, 0.02, 1.26, Springs::equal};
    p.pressure = {8, 8 / measureVolume(mesh.vertices, mesh.faces)};
    p.drag = 0.5;
    Body body = shakenBody(mesh, 0, 0);
    body.pressureConstant = 8;
    for (Point& x : body.position) x *= 1 + 1e-6;
    Lab lab(p, mesh, {body});
    double squares = 0;
    for (double length : lab.bodies.mesh.restLengths) squares += length * length;
    const double gamma = 0.02 * squares + 0.5, stiffness = 10 * squares + 72;
    const double omega = std::sqrt(stiffness - gamma * gamma / 4);
    lab.start();
    constexpr double dt = 0x1p-13;
    double before = meanRadius(lab) - 1, first = 0, last = 0;
    int crossings = 0;
    const auto envelopeAt = [&](double time) { return 1e-6 * std::exp(-gamma * time / 2) * stiffness; };
    Worst beyond;
    for (int i = 1; i * dt < 4; ++i) {
      lab.step(dt);
      const double now = meanRadius(lab) - 1, time = i * dt;
      if ((now > 0) != (before > 0)) {
        last = time - dt * now / (now - before);
        if (crossings++ == 0) first = last;
        // All energy is kinetic when the radius passes through rest: |λ'| = ω e^(−γt/2) times the initial stretch.
        const double speed = norm(lab.velocity(0, 0)) * std::sqrt(stiffness);
        beyond.see(std::abs(speed / envelopeAt(last) - 1));
      }
      before = now;
    }
    CAPTURE(static_cast<int>(integrator), crossings, omega);
    REQUIRE(crossings > 10);
    CHECK(std::numbers::pi * (crossings - 1) / (last - first) == Approx(omega).epsilon(1e-5));
    CHECK(beyond < 5e-3);
  }
}

TEST_CASE("A sphere at rest obeys Laplace's law, P = 2σ/R") {
  PhysicsParameters p = softCell();
  p.membrane = {10, 0.05, 1.26, Springs::equal};
  p.pressure = {8, 0};
  p.drag = 4;
  const Lab lab = stepped({p, makeIcosphere(3), bestIsa()}, 6000, 0x1p-8);
  const Bodies& b = lab.bodies;
  double virial = 0;  // Σ f L over the edges
  for (int e = 0; e < b.mesh.edgeCount(); ++e) {
    const double length = norm(b.vertex(0, b.mesh.edges[2 * e + 1]) - b.vertex(0, b.mesh.edges[2 * e]));
    virial += 10 * (length - b.mesh.restLengths[e]) * length;
  }
  const double volume = b.volume[0], pressure = b.pressure[0];
  // Any shape at rest has Σ x·f = 0.
  CHECK(3 * pressure * volume == Approx(virial).epsilon(1e-9));
  // The tension of a net of edges is their virial over twice the area; this net is a sphere to 0.3 %.
  const double area = measureArea(lab.positions(), b.mesh.mesh.faces);
  const double radius = cubeRoot(3 * volume / (4 * std::numbers::pi));
  CHECK(pressure == Approx(2 * (virial / (2 * area)) / radius).epsilon(3e-3));
}
