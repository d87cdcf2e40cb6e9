// Manufactured solutions [Roache 2002]. Every vertex has a prescribed smooth path and an outer force: mass times the
// path's acceleration, minus the model's force on the path, written out in this file. The path is then the exact
// solution, with damping, drag and large deformations. A run's deviation is the error of kernels and integrator, and
// falls with the integrator's order.
#include <array>
#include <functional>

#include "catch.h"
#include "lab.h"
#include "mesh/connectivity.h"

using namespace morula;

namespace {

/// The motion of a vertex at one time.
struct Motion {
  Vector position, velocity, acceleration;
};

using Path = std::function<Motion(int vertex, double time)>;
/// The model's forces on all vertices at a time, when every vertex is on its path.
using Forces = std::function<std::vector<Vector>(double time)>;

struct Manufactured {
  PhysicsParameters physics;
  Mesh mesh;
  Path path;
  Forces forces;
};

std::vector<Motion> motionsAt(const Manufactured& m, double time) {
  std::vector<Motion> all;
  for (int v = 0; v < static_cast<int>(m.mesh.vertices.size()); ++v) all.push_back(m.path(v, time));
  return all;
}

/// Ends an evaluation at `time`, with the outer forces that the path needs.
void force(Lab& lab, const Manufactured& m, const PhysicsStages& stages, double time, double timeStep) {
  const auto motions = motionsAt(m, time);
  const auto inner = m.forces(time);
  Reals& forces = lab.bodies.acceleration;
  for (int v = 0; v < static_cast<int>(motions.size()); ++v)
    lab.bodies.write(forces, 0, v,
                     lab.bodies.read(forces, 0, v) + lab.bodies.vertexMass[0] * motions[v].acceleration - inner[v]);
  kick(stages, lab.bodies, lab.bodies.block(0, 0), timeStep);
}

/// Returns the root mean square distance from the path at time 1.
double errorAfter(const Manufactured& m, Integrator integrator, int steps) {
  PhysicsParameters p = m.physics;
  p.integrator = integrator;
  const auto start = motionsAt(m, 0);
  Body body = shakenBody(m.mesh, 0, 0);
  body.pressureConstant = p.pressure.constant;
  for (std::size_t v = 0; v < start.size(); ++v)
    body.position[v] = start[v].position, body.velocity[v] = start[v].velocity;
  Lab lab(p, m.mesh, {body});
  lab.evaluate();
  force(lab, m, lab.stages, 0, 0);
  const double dt = 1.0 / steps;
  for (int i = 0; i < steps; ++i) {
    const bool four = !lab.stages.furtherDrifts.empty();  // Runge–Kutta: twice at half the step, twice at its end
    const std::array<double, 4> shares{four ? 0.5 : 1, 0.5, 1, 1};
    for (std::size_t k = 0; k <= lab.stages.furtherDrifts.size(); ++k) {
      const PhysicsStages stages = k == 0 ? lab.stages : furtherStages(lab.stages, k - 1);
      advance(stages, lab.bodies, lab.bodies.block(0, 0), dt);
      force(lab, m, stages, (i + shares[k]) * dt, dt);
    }
  }
  double sum = 0;
  const auto end = motionsAt(m, 1);
  const auto reached = lab.positions();
  for (std::size_t v = 0; v < end.size(); ++v) {
    const Vector off = reached[v] - end[v].position;
    sum += dot(off, off);
  }
  return std::sqrt(sum / static_cast<double>(end.size()));
}

void checkOrder(const Manufactured& m, Integrator integrator, double order, int steps) {
  double coarse = errorAfter(m, integrator, steps);
  CHECK(coarse < 0.1);
  for (int halving = 1; halving <= 3; ++halving) {
    const double fine = errorAfter(m, integrator, steps << halving);
    INFO("integrator " << static_cast<int>(integrator) << ", " << (steps << halving) << " steps: " << fine);
    CHECK(std::log2(coarse / fine) == Approx(order).margin(0.2));
    coarse = fine;
  }
}

// --- A shell that flies, turns, swells and ripples

/// c + A X + q with A = 1 + A₁ sin t + A₂ (1 − cos 2t), and each vertex' own ripple q = r sin(3t + φ).
Motion wander(const Mesh& mesh, int v, double t) {
  const Point& x = mesh.vertices[v];
  const Vector turn = cross({0.3, -0.5, 0.8}, x), swell{0.2 * x.x, 0.1 * x.y - 0.15 * x.z, 0.25 * x.z};
  const Vector flight{1, -2, 0.5}, ripple = 0.03 * noiseVector(static_cast<std::uint32_t>(v), 77);
  const double phase = 3 * t + v;
  return {x + std::sin(t) * (turn + flight) + (1 - std::cos(2 * t)) * swell + std::sin(phase) * ripple,
          std::cos(t) * (turn + flight) + 2 * std::sin(2 * t) * swell + 3 * std::cos(phase) * ripple,
          -std::sin(t) * (turn + flight) + 4 * std::cos(2 * t) * swell - 9 * std::sin(phase) * ripple};
}

/// Springs, gas and drag [Nilsson 2008, eq. 4.2–4.5], edge by edge and face by face.
std::vector<Vector> shellForces(const PhysicsParameters& p, const Mesh& mesh, double t) {
  std::vector<Motion> at;
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) at.push_back(wander(mesh, v, t));
  std::vector<Vector> f(at.size());
  for (const auto& [i, j] : makeConnectivity(mesh).edges) {
    const Vector d = at[j].position - at[i].position, e = d / norm(d);
    const double tension = p.membrane.stiffness * (norm(d) - norm(mesh.vertices[j] - mesh.vertices[i])) +
                           p.membrane.damping.constant * dot(at[j].velocity - at[i].velocity, e);
    f[i] += tension * e, f[j] -= tension * e;
  }
  std::vector<Point> x;
  for (const Motion& m : at) x.push_back(m.position);
  const double pressure = p.pressure.constant / measureVolume(x, mesh.faces) - p.pressure.outside;
  for (const auto& [a, b, c] : mesh.faces)
    for (int v : {a, b, c}) f[v] += (pressure / 6) * cross(x[b] - x[a], x[c] - x[a]);
  const double mass = p.cell.mass / static_cast<double>(at.size());
  for (std::size_t v = 0; v < at.size(); ++v) f[v] -= (p.drag * mass) * at[v].velocity;
  return f;
}

Manufactured shell() {
  PhysicsParameters p = softCell();
  p.membrane = {10, 0.05, 1.26, Springs::equal};
  p.pressure = {8, 1.5};
  p.drag = 0.5;
  const Mesh mesh = makeIcosphere(1);
  return {p, mesh, [mesh](int v, double t) { return wander(mesh, v, t); },
          [p, mesh](double t) { return shellForces(p, mesh, t); }};
}

// --- A cell of shape matching that turns and stretches

/// The map R(θ) D of a turning cell, with the turn R about z and D = diag(a, b, 1). R is the rotation nearest to the
/// map, and R's spin is the cell's.
struct Turning {
  double cosine, sine, rate, growth;  // cos θ, sin θ, θ' and θ'' of θ(t) = sin t
  double a, b, aRate, bRate, aGrowth, bGrowth;

  explicit Turning(double t)
      : cosine(std::cos(std::sin(t))),
        sine(std::sin(std::sin(t))),
        rate(std::cos(t)),
        growth(-std::sin(t)),
        a(1 + 0.2 * std::sin(2 * t)),
        b(1 - 0.15 * std::sin(3 * t)),
        aRate(0.4 * std::cos(2 * t)),
        bRate(-0.45 * std::cos(3 * t)),
        aGrowth(-0.8 * std::sin(2 * t)),
        bGrowth(1.35 * std::sin(3 * t)) {}
  Vector turn(const Vector& u) const { return {cosine * u.x - sine * u.y, sine * u.x + cosine * u.y, u.z}; }
};

constexpr Vector axis{0, 0, 1}, flightOf{0.5, 1, -1};

Motion turning(const Mesh& mesh, int v, double t) {
  const Turning m(t);
  const Point& q = mesh.vertices[v];
  const Vector at = m.turn({m.a * q.x, m.b * q.y, q.z}), stretching = m.turn({m.aRate * q.x, m.bRate * q.y, 0});
  const Vector spinning = m.rate * cross(axis, at);
  return {at + t * t * flightOf, spinning + stretching + 2 * t * flightOf,
          m.growth * cross(axis, at) + m.rate * cross(axis, spinning) + 2 * m.rate * cross(axis, stretching) +
              m.turn({m.aGrowth * q.x, m.bGrowth * q.y, 0}) + 2.0 * flightOf};
}

/// Mass times −k (p − T q) − κ (non-rigid velocity) − drag v, with T = β A/∛det A + (1 − β) R [Müller et al. 2005].
std::vector<Vector> shapeForces(const PhysicsParameters& p, const Mesh& mesh, double t) {
  const Turning m(t);
  const ShapeMatchingParameters& s = p.shapeMatching;
  const double linear = s.linear / std::cbrt(m.a * m.b), rigid = 1 - s.linear;
  std::vector<Vector> f;
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    const Point& q = mesh.vertices[v];
    const Vector at = m.turn({m.a * q.x, m.b * q.y, q.z}), goal = linear * at + rigid * m.turn(q);
    const Vector stretching = m.turn({m.aRate * q.x, m.bRate * q.y, 0});
    f.push_back((p.cell.mass / static_cast<double>(mesh.vertices.size())) *
                (s.stiffness * (goal - at) - s.damping * stretching - p.drag * turning(mesh, v, t).velocity));
  }
  return f;
}

Manufactured matchedShape() {
  PhysicsParameters p;
  p.cell.model = CellModel::shapeMatching;
  p.shapeMatching = {60, 0.6, 1.5};
  p.drag = 0.5;
  const Mesh mesh = makeIcosphere(1);  // equally heavy in all directions, else R would not be the nearest rotation
  return {p, mesh, [mesh](int v, double t) { return turning(mesh, v, t); },
          [p, mesh](double t) { return shapeForces(p, mesh, t); }};
}

}  // namespace

TEST_CASE("Paths' velocities and accelerations are their derivatives") {
  for (const Manufactured& m : {shell(), matchedShape()})
    for (const double t : {0.0, 0.3, 0.9}) {
      constexpr double h = 0x1p-12;
      Worst off;
      for (int v = 0; v < 42; ++v) {
        const Motion before = m.path(v, t - h), now = m.path(v, t), after = m.path(v, t + h);
        off.see(norm((0.5 / h) * (after.position - before.position) - now.velocity));
        off.see(norm((0.5 / h) * (after.velocity - before.velocity) - now.acceleration));
      }
      CHECK(off < 1e-6);  // h²/6 of third derivatives up to 27
    }
}

TEST_CASE("Cells follow manufactured paths with each integrator's order") {
  for (const Manufactured& m : {shell(), matchedShape()}) {
    INFO("model " << static_cast<int>(m.physics.cell.model));
    checkOrder(m, Integrator::velocityVerlet, 2, 64);
    checkOrder(m, Integrator::rungeKutta4, 4, 32);
    checkOrder(m, Integrator::symplecticEuler, 1, 128);
    checkOrder(m, Integrator::thesisVerlet, 1, 128);
    checkOrder(m, Integrator::explicitEuler, 1, 1024);
    if (m.physics.cell.model == CellModel::shell) checkOrder(m, Integrator::xpbd, 1, 256);
  }
}
