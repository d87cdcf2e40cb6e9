// Position-based dynamics: closed forms, conserved quantities, and stability with any time step.
#include <algorithm>

#include "catch.h"
#include "lab.h"
#include "physics/stability.h"

using namespace morula;

namespace {

PhysicsParameters byPositions(std::uint64_t substeps = 1) {
  PhysicsParameters p = softCell();
  p.integrator = Integrator::xpbd;
  p.substeps = substeps;
  return p;
}

Vector angularMomentum(const Lab& lab) {
  Vector sum;
  for (int v = 0; v < lab.bodies.vertexCount(); ++v) sum += cross(lab.bodies.vertex(0, v), lab.velocity(0, v));
  return lab.bodies.vertexMass[0] * sum;
}

/// Returns the energy of motion, springs and gas; the gas has −k_p ln V + P_0 V.
double energy(const Lab& lab) {
  const Bodies& b = lab.bodies;
  double sum = 0;
  for (int v = 0; v < b.vertexCount(); ++v) sum += 0.5 * b.vertexMass[0] * dot(lab.velocity(0, v), lab.velocity(0, v));
  for (int e = 0; e < b.mesh.edgeCount(); ++e) {
    const double length = norm(b.vertex(0, b.mesh.edges[2 * e + 1]) - b.vertex(0, b.mesh.edges[2 * e]));
    const double stretch = length - b.restScale[0] * b.mesh.restLengths[e];
    sum += 0.5 * b.parameters.membrane.stiffness * stretch * stretch;
  }
  return sum - b.pressureConstant[0] * std::log(b.volume[0]) + b.parameters.pressure.outside * b.volume[0];
}

double volumeAtRest(const Lab& lab) { return measureVolume(lab.bodies.mesh.mesh.vertices, lab.bodies.mesh.mesh.faces); }

/// Extremes of a run of a cell whose rest shape is its mesh: volumes relative to rest, energies minus rest.
struct Ride {
  double minVolume = INFINITY, maxVolume = 0, maxEnergy = -INFINITY, firstEnergy = 0, endEnergy = 0;
};

Ride ride(Lab& lab, double timeStep, int steps) {
  lab.start();
  Ride r;
  const double atRest = lab.bodies.pressureConstant[0] * (1 - std::log(volumeAtRest(lab)));
  r.firstEnergy = energy(lab) - atRest;
  for (int i = 0; i < steps; ++i) {
    lab.step(timeStep);
    const double volume = lab.bodies.volume[0] / volumeAtRest(lab);
    r.minVolume = std::min(r.minVolume, volume), r.maxVolume = std::max(r.maxVolume, volume);
    r.endEnergy = energy(lab) - atRest;
    r.maxEnergy = std::max(r.maxEnergy, r.endEnergy);
  }
  return r;
}

Body stretched(const Mesh& mesh, const Vector& by, double pressureConstant) {
  Body body = shakenBody(mesh, 0, 0);
  body.pressureConstant = pressureConstant;
  for (Point& x : body.position) x = {by.x * x.x, by.y * x.y, by.z * x.z};
  return body;
}

}  // namespace

TEST_CASE("One stretched edge after another: each is backward Euler's spring in closed form") {
  // A first step without contents, computed by hand in doubles and in the same order.
  PhysicsParameters p = byPositions();
  p.membrane = {40, 0.5, 1.26, Springs::equal};
  p.pressure = {0, 0};
  const Mesh mesh = zoo::crumpled(zoo::tetrahedron(), 0.2, 3);
  Lab lab(p, zoo::tetrahedron(), {shakenBody(mesh, 0, 1)});
  lab.start();
  constexpr double h = 0.125, m = 0.25;
  std::vector<Point> x = lab.positions();
  std::vector<Vector> u;
  for (int v = 0; v < 4; ++v) u.push_back(lab.velocity(0, v)), x[v] += h * u[v];
  for (int e = 0; e < lab.bodies.mesh.edgeCount(); ++e) {
    const int i = lab.bodies.mesh.edges[2 * e], k = lab.bodies.mesh.edges[2 * e + 1];
    const Vector d = x[k] - x[i], n = d / norm(d);
    // The force f = k_s C' + k_d C'' of stretch C' and rate C'' at the end of the step, which are eliminated.
    const double stretch = norm(d) - lab.bodies.mesh.restLengths[e], rate = dot(u[k] - u[i], n);
    const double force = (40 * stretch + 0.5 * rate) / (1 + 2 * h * (h * 40 + 0.5) / m);
    u[i] += (h * force / m) * n, u[k] -= (h * force / m) * n;
    x[i] += (h * h * force / m) * n, x[k] -= (h * h * force / m) * n;
    // Stretch and rate after the step give the force f back.
    CHECK(40 * (dot(x[k] - x[i], n) - lab.bodies.mesh.restLengths[e]) + 0.5 * dot(u[k] - u[i], n) ==
          Approx(force).epsilon(1e-12));
  }
  // The step then turns the body to keep Σ x₀ × u, which is linear in the turn: three trials and Cramer's rule find it.
  const std::vector<Point> before = lab.positions();
  Vector centre, kept;
  for (int v = 0; v < 4; ++v) centre += x[v] / 4.0, kept += cross(before[v], lab.velocity(0, v));
  const auto lost = [&](const Vector& turn) {
    Vector sum = -kept;
    for (int v = 0; v < 4; ++v) sum += cross(before[v], u[v] - cross(turn, x[v] - centre));
    return sum;
  };
  const Vector none = lost({}), a = none - lost({1, 0, 0}), b = none - lost({0, 1, 0}), c = none - lost({0, 0, 1});
  const double det = dot(a, cross(b, c));
  const Vector turn{dot(none, cross(b, c)) / det, dot(a, cross(none, c)) / det, dot(a, cross(b, none)) / det};
  CHECK(norm(none) > 1e-3);
  CHECK(norm(lost(turn)) < 1e-15);
  for (int v = 0; v < 4; ++v) {
    const Vector change = -1.0 * cross(turn, x[v] - centre);
    u[v] += change, x[v] += h * change;
  }
  lab.step(h);
  for (int v = 0; v < 4; ++v) {
    CHECK(norm(lab.bodies.vertex(0, v) - x[v]) < 1e-14);
    CHECK(norm(lab.velocity(0, v) - u[v]) < 1e-14);
  }
}

TEST_CASE("Without outer forces sub-steps are time steps, bit for bit") {
  for (const double drag : {0.0, 0.5}) {
    const Mesh mesh = makeIcosphere(1);
    PhysicsParameters p = byPositions();
    p.drag = drag;
    Lab steps(p, mesh, {shakenBody(mesh, 0.05, 1)});
    p.substeps = 4;
    Lab substeps(p, mesh, {shakenBody(mesh, 0.05, 1)});
    steps.start(), substeps.start();
    for (int i = 0; i < 100; ++i) {
      substeps.step(0x1p-5);
      for (int k = 0; k < 4; ++k) steps.step(0x1p-7);
    }
    CHECK(takeBody(steps.bodies, 0).position == takeBody(substeps.bodies, 0).position);
    CHECK(takeBody(steps.bodies, 0).velocity == takeBody(substeps.bodies, 0).velocity);
  }
}

TEST_CASE("Contents take the pressure that they have after the step") {
  // A ball of gas without springs: p = k_p/V' − P_0 with V' = V + c p, to first order. Steps are short, comparable and
  // long against the period of breathing.
  const Mesh mesh = makeIcosphere(1);
  const double rest = measureVolume(mesh.vertices, mesh.faces);
  for (const double scale : {0.5, 1.0, 1.4})
    for (const double h : {1e-3, 1.0, 1e3}) {
      PhysicsParameters p = byPositions();
      p.membrane = {0, 0, 1.26};
      p.pressure = {4, 3};
      Lab lab(p, mesh, {stretched(mesh, {scale, scale, scale}, 4)});
      lab.start();
      const double volume = scale * scale * scale * rest;
      lab.step(h);
      // All vertices of one orbit move alike along ∇V: Δx = h² p ∇V/m, and Σ ∇V·Δx = c p.
      double gained = 0, squares = 0;
      Lab before = evaluated({p, mesh, {stretched(mesh, {scale, scale, scale}, 4)}});
      for (int v = 0; v < 42; ++v) {
        const BlockView block = before.bodies.block(0, 0);
        const double* g = static_cast<double*>(block.gradient.place) + v * vertexStride;
        const Vector gradient = Vector{g[0], g[blockLanes], g[2 * blockLanes]} / 6.0;
        squares += dot(gradient, gradient);
        gained += dot(gradient, lab.bodies.vertex(0, v) - before.bodies.vertex(0, v));
      }
      const double c = h * h * squares * 42, pressure = gained / c;
      CAPTURE(scale, h, c, pressure);
      CHECK(pressure + 3 == Approx(4 / (volume + gained)).epsilon(1e-11));
    }
}

TEST_CASE("Momentum and angular momentum stay to rounding, and a resting cell does not begin to spin") {
  const Mesh mesh = makeIcosphere(1);
  for (const double timeStep : {0x1p-10, 0x1p-6, 0x1p-4})
    for (const Vector& place : {Vector{}, Vector{100, -200, 50}}) {
      Body body = shakenBody(mesh, 0.05, 0.5);
      body.pressureConstant = 4;
      for (std::size_t v = 0; v < body.velocity.size(); ++v) {
        body.velocity[v] += Vector{1, 0, 0} + cross(Vector{0, 0, 2}, body.position[v]);
        body.position[v] += place;
      }
      PhysicsParameters p = byPositions();
      p.membrane.damping = 0.05;
      Lab lab(p, mesh, {body});
      lab.start();
      const Vector linear = momentumOf(lab.bodies), angular = angularMomentum(lab);
      CHECK(norm(angular) > 0.5);
      for (int i = 0; i < 1000; ++i) lab.step(timeStep);
      CAPTURE(timeStep, place.x);
      CHECK(norm(momentumOf(lab.bodies) - linear) < 1e-13);
      CHECK(norm(angularMomentum(lab) - angular) < 1e-12 * (1 + norm(place)) * (1 + 1000 * timeStep));
    }
}

TEST_CASE("A spinning cell spins on, also where it turns too far in a step to be kept from slowing down") {
  const Mesh mesh = makeIcosphere(1);
  for (const double spin : {1.0, 5.0, 1e3}) {
    Body body = shakenBody(mesh, 0, 0);
    body.pressureConstant = 4;
    for (std::size_t v = 0; v < body.velocity.size(); ++v)
      body.velocity[v] = cross(Vector{0, 0, spin}, body.position[v]);
    Lab lab(byPositions(), mesh, {body});
    lab.start();
    const double before = angularMomentum(lab).z;
    for (int i = 0; i < 100; ++i) lab.step(0x1p-6);
    const double kept = angularMomentum(lab).z / before;
    CAPTURE(spin, kept);
    if (spin < 10) CHECK(kept == Approx(1).epsilon(1e-12));
    else CHECK((kept > 0 && kept < 1));
  }
}

TEST_CASE("The cell of 642 vertices rests at its radius as sub-steps grow short") {
  // The radius is 1.053101148 if forces balance at one moment. In a sub-step they act one after another, on positions
  // that earlier ones have moved. The stretch is off by O(h²), and the rate, which damping uses, by O(h).
  const auto deviation = [](std::uint64_t substeps, double damping) {
    PhysicsParameters p = byPositions(substeps);
    p.membrane = {10, damping, 1.26, Springs::equal};
    p.pressure = {8, 0};
    p.drag = 4;
    const Lab lab = stepped({p, makeIcosphere(3), bestIsa()}, 10 << 8, 0x1p-8);
    CHECK(fastestVertex(lab.bodies) < 1e-6);
    return meanRadius(lab) - 1.053101148;
  };
  const double one = deviation(1, 0), two = deviation(2, 0), four = deviation(4, 0), damped = deviation(4, 0.05),
               dampedToo = deviation(8, 0.05);
  CAPTURE(one, two, four, damped, dampedToo);
  CHECK(std::abs(four) < 4e-4);
  CHECK(std::log2(one / two) == Approx(2).margin(0.2));
  CHECK(std::log2(two / four) == Approx(2).margin(0.2));
  CHECK(std::abs(damped) < 2e-3);
  CHECK(std::log2(damped / dampedToo) == Approx(1).margin(0.2));
}

TEST_CASE("No time step is too long: stiff, at a hundred times the others' limit and more") {
  const Mesh mesh = makeIcosphere(2);
  const double rest = measureVolume(mesh.vertices, mesh.faces);
  const Vector little{1.03, 0.985, 0.985}, much{1.5, 0.8, 0.8}, needle{4, 0.5, 0.5}, pancake{2.5, 2.5, 0.16};
  struct Case {
    double stiffness, gas;
    Vector by;
    double maxEnergy;  // relative to the initial energy
  };
  // One sweep over edges far from rest may leave a fifth more energy, which later sweeps take. With soft edges around
  // stiff contents a slight error of the volume outweighs the edges' energy.
  for (const auto& [stiffness, gas, by, maxEnergy] :
       {Case{10, 200, little, 1}, Case{10, 200, much, 1.01}, Case{10, 200, needle, 1.2}, Case{10, 200, pancake, 1.1},
        Case{10e4, 200e4, little, 1}, Case{10e4, 200e4, much, 1.01}, Case{10e4, 200e4, needle, 1.2},
        Case{10e4, 200e4, pancake, 1.1}, Case{10, 200e4, little, 1}, Case{10, 200e4, much, 1},
        Case{10, 200e4, needle, INFINITY}, Case{10, 200e4, pancake, INFINITY}, Case{10e4, 200, little, 1}})
    for (const double times : {1.0, 10.0, 100.0, 1e4})
      for (const double damping : {0.0, 0.05}) {
        PhysicsParameters p = softCell();
        p.membrane = {stiffness, damping, 1.26, Springs::equal};
        p.pressure = {gas, gas / rest};
        const StabilityLimits limits = measureLimits(evaluated({p, mesh}).bodies, 0);
        const double limit = std::min(limits.spring, limits.pressure);
        p.integrator = Integrator::xpbd;
        Lab lab(p, mesh, {stretched(mesh, by, gas)}, bestIsa());
        const Ride r = ride(lab, times * limit, 400);
        CAPTURE(stiffness, gas, by.x, times, damping, r.firstEnergy, r.maxEnergy, r.endEnergy);
        CHECK(r.minVolume > 0.5);  // a needle rightly dips to 0.62 if the step follows it
        CHECK(r.maxVolume < 1.25);
        CHECK(r.maxEnergy <= maxEnergy * r.firstEnergy);
        CHECK(r.endEnergy < r.firstEnergy);
      }
}

TEST_CASE("XPBD has no limit but that of contacts") {
  const StabilityLimits limits = measureLimits(evaluated({byPositions(), makeIcosphere(1)}).bodies, 0);
  CHECK(limits.spring == INFINITY);
  CHECK(limits.pressure == INFINITY);
  CHECK(dragLimit(Integrator::xpbd, 100) == INFINITY);
  CHECK(contactLimit(Integrator::xpbd, 30, 0.02, 1) == contactLimit(Integrator::symplecticEuler, 30, 0.02, 1));
}
