// Dissipation between touching cells: damping and viscosity.
#include "catch.h"
#include "pair_oracle.h"

using namespace morula;

namespace {

/// Returns the power −Σ F·v of damping and viscosity. [force·length/time]
double dissipated(const ContactParameters& law, const Mesh& mesh, const std::vector<Body>& cells) {
  ContactParameters without = law;
  without.damping = without.viscosity = 0;
  const Crowd with = evaluated({limp(), law, mesh, cells}), bare = evaluated({limp(), without, mesh, cells});
  double power = 0;
  for (int slot = 0; slot < with.lab.bodies.count; ++slot)
    for (int v = 0; v < with.lab.bodies.vertexCount(); ++v)
      power -= dot(with.lab.force(slot, v) - bare.lab.force(slot, v), with.lab.velocity(slot, v));
  return power;
}

/// Returns two balls that overlap a little, both turned at random, the right one moving.
Crowd rubbing(const ContactParameters& law, const Vector& velocity, std::uint32_t key = 0, double timeStep = 0x1p-30) {
  const Mesh ball = makeIcosphere(3);
  const Body left = turnedBody(ball, key);
  Body right = turnedBody(ball, key + 1000, 1, {1.97, 0, 0});
  for (Vector& u : right.velocity) u = velocity;
  Crowd crowd(limp(), law, ball, {left, right});
  crowd.lawTimeStep = timeStep;
  crowd.evaluateForces();
  return crowd;
}

}  // namespace

TEST_CASE("Damping and viscosity take energy from cells in a heap, and never give any") {
  const ContactParameters damped{ContactLaw::pair, 40, 0.5}, rubs{ContactLaw::pair, 40, 0, 0.5},
      both{ContactLaw::pair, 40, 0.2, 0.3};
  for (const int level : {1, 2}) {
    const Mesh ball = makeIcosphere(level);
    for (const ContactParameters& law : {damped, rubs, both})
      for (std::uint32_t key = 0; key < 30; ++key) {
        // Cells move and turn as a whole, and each vertex moves a little on its own.
        auto cells = heap(ball, 9, 1.7, 0.05, key);
        for (std::uint32_t c = 0; c < cells.size(); ++c)
          for (std::size_t v = 0; v < cells[c].position.size(); ++v)
            cells[c].velocity[v] +=
                noiseVector(c, 40 + key) + cross(noiseVector(c, 90 + key), cells[c].position[v] - cells[c].position[0]);
        CAPTURE(level, law.damping, law.viscosity, key);
        CHECK(dissipated(law, ball, cells) > 0);
        for (Body& cell : cells)
          for (Vector& u : cell.velocity) u = {0.3, -0.2, 0.1};  // all cells move together
        CHECK(std::abs(dissipated(law, ball, cells)) < 1e-12);
      }
  }
}

TEST_CASE("Damping acts against approach only; cells that are torn apart feel no more than a trace of pull") {
  const auto pushAt = [&](double approach) {
    return rubbing({ContactLaw::pair, 40, 0.5}, {-approach, 0, 0}).lab.forceOn(1).x;
  };
  CHECK(pushAt(1) > 1.2 * pushAt(0));
  CHECK(pushAt(0) > 1.2 * pushAt(-1));
  CHECK(std::abs(pushAt(-1000)) < 0.1 * pushAt(0));  // the trace comes from the push's fade with distance
}

TEST_CASE("Viscosity alone drives nothing: cells at rest, or in one motion, feel none") {
  for (const Vector& all : {Vector{}, Vector{0.5, 1, -2}}) {
    auto cells = heap(ball, 9, 1.6, 0);
    for (Body& cell : cells)
      for (Vector& u : cell.velocity) u = all;
    const Crowd with = evaluated({limp(), {ContactLaw::pair, 40, 0, 0.5}, ball, cells}),
                without = evaluated({limp(), {ContactLaw::pair, 40, 0}, ball, cells});
    Worst difference;
    for (int slot = 0; slot < 9; ++slot)
      for (int v = 0; v < with.lab.bodies.vertexCount(); ++v)
        difference.see(norm(with.lab.force(slot, v) - without.lab.force(slot, v)));
    CHECK(largestForce(without.lab) > 1);
    CHECK(difference == 0);
  }
}

TEST_CASE("Viscosity acts against the slip, at most by its share of the normal force") {
  constexpr double slipSpeed = 100;  // so high that the damper's bound (next test) never applies
  const auto onRight = [&](double viscosity, double slip, std::uint32_t key = 0, double timeStep = 0x1p-30) {
    return rubbing({ContactLaw::pair, 40, 0, viscosity, slipSpeed}, {0, slip, 0}, key, timeStep).lab.forceOn(1);
  };
  double pressed = 0, rubbed = 0;  // sums over turns, since it is chance how vertices face each other
  for (std::uint32_t key = 0; key < 40; ++key) {
    pressed += onRight(0, 1e4, key).x;
    rubbed += onRight(0, 1e4, key).y - onRight(0.3, 1e4, key).y;
  }
  CHECK(rubbed == Approx(0.3 * pressed).epsilon(0.05));

  const double without = onRight(0, 1).y, fast = onRight(0.3, 1e4).y - without, faster = onRight(0.3, 5e4).y - without,
               slow = onRight(0.3, 1).y - without;
  CHECK(fast < 0);
  CHECK(faster == Approx(fast).epsilon(1e-6));       // beyond the slip speed viscosity does not grow
  CHECK(slow == Approx(fast * 0.01).epsilon(1e-2));  // below the slip speed viscosity fades linearly
  CHECK(onRight(0.3, 2).y - without == Approx(2 * slow).epsilon(1e-5));
  CHECK(onRight(0.3, 1e6, 0, 0x1p-2).y - without == Approx(fast).epsilon(1e-6));  // with any time step
}

TEST_CASE("What slips slowly is damped alike at every short time step, and is not reversed by a long one") {
  const auto onRight = [&](double viscosity, double slip, double timeStep) {
    return rubbing({ContactLaw::pair, 40, 0, viscosity, 0.01}, {0, slip, 0}, 0, timeStep).lab.forceOn(1).y;
  };
  const double slip = 1e-4, without = onRight(0, slip, 0x1p-9), damped = onRight(0.3, slip, 0x1p-9) - without;
  CHECK(damped < 0);
  for (const double timeStep : {0x1p-10, 0x1p-12, 0x1p-30})
    CHECK(onRight(0.3, slip, timeStep) - without == Approx(damped).epsilon(1e-12));
  CHECK(onRight(0.3, 2 * slip, 0x1p-9) - without == Approx(2 * damped).epsilon(1e-5));
  CHECK(onRight(0.6, slip, 0x1p-9) - without == Approx(damped).epsilon(1e-5));  // far within the limit

  const double longStep = 0x1p-2;  // too long for a damper this strong
  const double gentle = onRight(0.3, slip, longStep) - without;
  CHECK(gentle < 0);
  CHECK(-gentle < 0.5 * -damped);
  CHECK(-gentle * longStep < slip);  // the right ball's mass is 1
}
