// The order of the integrators: a cell under pressure is released, and its error falls with Δt, Δt² or Δt⁴.
#include "catch.h"
#include "lab.h"

using namespace morula;

namespace {

/// Returns positions at time 1 of a blown-up cell, uneven and damped, so that no errors cancel.
std::vector<Point> released(Integrator integrator, int steps, double drag) {
  PhysicsParameters p = softCell();
  p.integrator = integrator;
  p.membrane = {10, 0.02, 1.26, Springs::equal};
  p.pressure = {8, 0};
  p.drag = drag;
  const Mesh mesh = zoo::scaled(makeIcosphere(1), {1.2, 1, 0.9});
  return stepped({p, mesh}, steps, 1.0 / steps).positions();
}

/// Returns the root mean square distance over the vertices.
double distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += dot(a[v] - b[v], a[v] - b[v]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Returns log2 of the ratio of errors for each halving of the step.
std::vector<double> observedOrders(Integrator integrator, double drag, int steps) {
  const auto reference = released(Integrator::rungeKutta4, 1 << 13, drag);
  std::vector<double> orders;
  double coarse = distance(released(integrator, steps, drag), reference);
  CHECK(coarse < 0.1);
  for (int halving = 1; halving <= 3; ++halving) {
    const double fine = distance(released(integrator, steps << halving, drag), reference);
    orders.push_back(std::log2(coarse / fine));
    coarse = fine;
  }
  return orders;
}

}  // namespace

TEST_CASE("Each integrator has its order, with damping, and with and without drag") {
  struct Case {
    Integrator integrator;
    double order;
    int steps;
  };
  for (const auto& [integrator, order, steps] :
       {Case{Integrator::velocityVerlet, 2, 128}, Case{Integrator::thesisVerlet, 1, 128},
        Case{Integrator::explicitEuler, 1, 2048}, Case{Integrator::symplecticEuler, 1, 512},
        Case{Integrator::rungeKutta4, 4, 128}, Case{Integrator::xpbd, 1, 512}})
    for (double drag : {0.0, 0.5})
      for (double observed : observedOrders(integrator, drag, steps)) {
        CAPTURE(static_cast<int>(integrator), drag);
        CHECK(observed == Approx(order).margin(0.2));
      }
}

TEST_CASE("Velocity Verlet and Runge-Kutta go to one and the same place") {
  const auto byVerlet = released(Integrator::velocityVerlet, 1 << 15, 0.5);
  CHECK(distance(byVerlet, released(Integrator::rungeKutta4, 1 << 12, 0.5)) < 2e-7);
}

TEST_CASE("The thesis' Verlet is x' = 2x − x_prev + a Δt²") {
  PhysicsParameters p = softCell();
  p.integrator = Integrator::thesisVerlet;
  p.pressure = {8, 0};
  p.membrane.damping = 0;
  const Mesh mesh = zoo::crumpled(makeIcosphere(1), 0.1, 1);
  constexpr double dt = 0x1p-8;
  Lab lab(p, mesh);
  lab.start();
  std::vector<Point> before = lab.positions(), now = before;  // x_prev = x_0 [Nilsson 2008, eq. 4.6]
  for (int i = 0; i < 50; ++i) {
    std::vector<Point> next(now.size());
    for (std::size_t v = 0; v < now.size(); ++v)
      next[v] = 2.0 * now[v] - before[v] + (dt * dt) * lab.force(0, static_cast<int>(v));  // an acceleration by now
    lab.step(dt);
    before = now;
    now = next;
  }
  CHECK(distance(now, lab.positions()) < 1e-12);
}

TEST_CASE("Velocity Verlet without damping keeps the energy, up to a ripple that does not grow") {
  PhysicsParameters p = softCell();
  p.membrane = {10, 0, 1.26, Springs::equal};
  p.pressure = {0, 0};
  const Mesh mesh = makeIcosphere(1);
  Lab lab(p, mesh, {shakenBody(mesh, 0.1, 0)});
  const auto& edges = lab.bodies.mesh.edges;
  const auto energy = [&] {
    double sum = 0;
    for (int v = 0; v < 42; ++v) sum += 0.5 / 42 * dot(lab.velocity(0, v), lab.velocity(0, v));
    for (int e = 0; e < lab.bodies.mesh.edgeCount(); ++e) {
      const double length = norm(lab.bodies.vertex(0, edges[2 * e + 1]) - lab.bodies.vertex(0, edges[2 * e]));
      const double stretch = length - lab.bodies.mesh.restLengths[e];
      sum += 0.5 * 10 * stretch * stretch;
    }
    return sum;
  };
  lab.start();
  const double atFirst = energy();
  Worst early, late;
  for (int i = 0; i < 20000; ++i) {
    lab.step(0x1p-9);
    (i < 2000 ? early : late).see(std::abs(energy() / atFirst - 1));
  }
  CHECK(early < 0.01);
  CHECK(late < 2 * early);
}
