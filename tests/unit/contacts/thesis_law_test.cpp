// The thesis' law against its equations, written out for all pairs. Its known faults are tested, too, so that they
// stay.
#include "catch.h"
#include "crowd.h"

using namespace morula;

namespace {

constexpr double dt = 0x1p-9;
const ContactParameters thesis{ContactLaw::thesis};

/// Returns the penetration vector of a vertex [Nilsson 2008, §4.3.1]: the direction and distance that it must move.
/// Weights are inverse distances, in influence radii.
Vector penetration(const SeenVertex& i, const std::vector<SeenVertex>& all) {
  Vector sum;
  double weights = 0;
  for (const SeenVertex& j : all) {
    const Vector d = i.x - j.x;
    const double radius = 1 / std::sqrt((i.inverseRadiusSquared + j.inverseRadiusSquared) / 2);
    if (i.slot == j.slot || norm(d) >= radius || dot(i.normal, j.normal) >= 0) continue;
    const Vector fromJ = std::max(0.0, -dot(d, j.normal)) * j.normal,
                 fromI = std::max(0.0, dot(d, i.normal)) * i.normal;
    sum += (0.5 * radius / norm(d)) * (fromJ - fromI);
    weights += radius / norm(d);
  }
  return weights > 0 ? sum / weights : sum;
}

}  // namespace

TEST_CASE("Contact forces are eq. 4.8 over all pairs of vertices, by brute force") {
  PhysicsParameters springs = limp();
  springs.membrane.stiffness = 5;  // makes f_other differ from 0
  for (const PhysicsParameters& p : {limp(), springs})
    for (int count : {2, 9}) {
      Crowd crowd(p, thesis, ball, heap(ball, count, 1.6, 0.5));
      Lab& lab = crowd.lab;
      lab.evaluate();
      std::vector<Vector> other;
      const auto all = seen(lab.bodies, thesis);
      for (const SeenVertex& i : all) other.push_back(lab.force(i.slot, i.v));
      crowd.lawTimeStep = dt;
      crowd.evaluateForces();
      Worst error, largest;
      for (std::size_t k = 0; k < all.size(); ++k) {
        const SeenVertex& i = all[k];
        const Vector way = penetration(i, all);
        Vector expected = other[k];
        if (norm(way) > 0) {
          const Vector out = way / norm(way);
          const double m = lab.bodies.vertexMass[i.slot];
          expected += 0.5 * m * (norm(way) / (dt * dt) - dot(i.velocity, out) / dt - dot(other[k], out) / m) * out;
        }
        error.see(norm(lab.force(i.slot, i.v) - expected));
        largest.see(norm(expected));
      }
      CHECK(largest > 10);
      CHECK(error < 1e-6 * largest);
    }
}

TEST_CASE("Its stiffness grows with the inverse square of the time step") {
  const auto push = [&](double timeStep) {
    Crowd crowd(limp(), thesis, ball, heap(ball, 2, 1.6, 0));
    crowd.lawTimeStep = timeStep;
    crowd.evaluateForces();
    return largestForce(crowd.lab);
  };
  CHECK(push(dt / 2) == Approx(4 * push(dt)).epsilon(1e-12));
}

TEST_CASE("Nothing acts back on the other cell: it does not keep momentum, and that is why it is not the default") {
  const Crowd crowd = evaluated({limp(), thesis, ball, heap(ball, 2, 1.6, 0)});
  Vector sum;
  double size = 0;
  for (int slot : {0, 1})
    for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) {
      sum += crowd.lab.force(slot, v);
      size += norm(crowd.lab.force(slot, v));
    }
  CHECK(norm(sum) > 1e-3 * size);
  CHECK(makeContacts({}, Isa::scalar).parameters.law == ContactLaw::pair);
}
