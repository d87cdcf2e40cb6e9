// The pair-symmetric law against its equations, written out for all pairs.
#include "catch.h"
#include "crowd.h"

using namespace morula;

namespace {

/// The force of j on i, from the equations of pair_law_kernel.h.
Vector pairForce(const SeenVertex& i, const SeenVertex& j, const ContactParameters& c, double strongestGrip) {
  const Vector d = i.x - j.x;
  const double inverseSquare = (i.inverseRadiusSquared + j.inverseRadiusSquared) / 2;  // 1/R²
  if (dot(d, d) * inverseSquare >= 1) return {};
  const Vector h = (j.normal - i.normal) / 2.0, v = i.velocity - j.velocity;
  const double gap = std::max(dot(d, j.normal), -dot(d, i.normal));
  const double alongSquare = dot(d, d) - gap * gap;
  const double weight = (1 - alongSquare * inverseSquare) * (1 - alongSquare * inverseSquare);
  const double push = -c.stiffness * gap - c.damping * dot(v, h);
  if (push <= 0) return {};
  const Vector f = weight * push * h;
  if (norm(h) == 0) return {};
  const Vector n = h / norm(h), slip = v - dot(v, n) * n;
  return f - std::min(c.friction * norm(f) / std::max(norm(slip), c.slipSpeed), strongestGrip) * slip;
}

struct Case {
  const char* name;
  ContactParameters law;
};

const std::vector<Case> cases{{"plain", {}},
                              {"no damping", {ContactLaw::pair, 40, 0}},
                              {"friction", {ContactLaw::pair, 40, 0.05, 0.3}},
                              {"sticky", {ContactLaw::pair, 40, 0.05, 2, 10}},
                              {"wide", {ContactLaw::pair, 40, 0.05, 0.1, 0.01, 2.5}}};

}  // namespace

TEST_CASE("Contact forces are the sum of the pair forces over all pairs of vertices, by brute force") {
  const Mesh ball = makeIcosphere(1);
  for (const auto& [name, law] : cases)
    for (int count : {2, 3, 9}) {
      Crowd crowd(limp(), law, ball, heap(ball, count, 1.6, 0.5));
      crowd.evaluateForces();
      const auto all = seen(crowd.lab.bodies, law);
      const auto& masses = crowd.lab.bodies.vertexMass;
      const double grip =
          0.1 * *std::min_element(masses.begin(), masses.begin() + count) / crowd.lawTimeStep;
      Worst error, largest;
      for (const SeenVertex& i : all) {
        Vector sum;
        for (const SeenVertex& j : all)
          if (i.slot != j.slot) sum += pairForce(i, j, law, grip);
        error.see(norm(crowd.lab.force(i.slot, i.v) - sum));
        largest.see(norm(sum));
      }
      CAPTURE(name, count);
      CHECK(largest > 1);
      // The normal's last float digit may round otherwise here and there.
      CHECK(error < 1e-6 * largest);
    }
}

TEST_CASE("On any pair of cells the forces are equal and opposite, friction or not") {
  const Mesh ball = makeIcosphere(1);
  for (const auto& [name, law] : cases)
    for (std::uint32_t key = 0; key < 10; ++key) {
      Crowd crowd(limp(), law, ball, heap(ball, 2, 1.6, 0.5, key));
      crowd.evaluateForces();
      Vector sums[2];
      double size = 0;
      for (int slot : {0, 1})
        for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) {
          sums[slot] += crowd.lab.force(slot, v);
          size += norm(crowd.lab.force(slot, v));
        }
      CAPTURE(name, key);
      CHECK(size > 0.1);
      CHECK(norm(sums[0] + sums[1]) < 1e-15 * size);
    }
}

TEST_CASE("Two balls that overlap are pushed apart along the line between them; balls apart feel nothing") {
  const Mesh ball = makeIcosphere(2);
  double before = 0;
  for (double distance : {2.5, 1.95, 1.9, 1.8}) {
    Body left = shakenBody(ball, 0, 0), right = left;
    for (Point& x : right.position) x += Vector{distance, 0, 0};
    Crowd crowd(limp(), {}, ball, {left, right});
    crowd.evaluateForces();
    Vector push;
    for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) push += crowd.lab.force(1, v);
    CAPTURE(distance);
    if (distance > 2) CHECK(norm(push) == 0);
    else CHECK(push.x > 1.5 * before);
    CHECK(std::abs(push.y) + std::abs(push.z) <= 0.02 * push.x);
    before = push.x;
  }
}

TEST_CASE("The force is continuous: no jump when a pair comes into reach, or when it begins to overlap") {
  const Mesh ball = makeIcosphere(1);
  Body left = shakenBody(ball, 0, 0), right = left;
  for (Point& x : right.position) x += Vector{2.3, 0.1, 0.05};
  Crowd crowd(limp(), {}, ball, {left, right});
  Vector before;
  Worst jump, largest;
  for (int i = 0; i < 4000; ++i) {
    for (std::size_t v = 0; v < right.position.size(); ++v)
      crowd.lab.setPosition(1, static_cast<int>(v), right.position[v] - Vector{i * 1e-4, 0, 0});
    crowd.evaluateForces();
    Vector push;
    for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) push += crowd.lab.force(1, v);
    jump.see(norm(push - before));
    largest.see(norm(push));
    before = push;
  }
  CHECK(largest > 2);
  CHECK(jump < 0.01 * largest);
}

TEST_CASE("Vertices at one place, or with parallel normals, do not make a force infinite") {
  const Mesh ball = makeIcosphere(1);
  const Body one = shakenBody(ball, 0, 0);
  for (double friction : {0.0, 0.5}) {
    Crowd crowd(limp(), {ContactLaw::pair, 40, 0.05, friction}, ball, {one, one, one});
    crowd.evaluateForces();
    Worst largest;
    for (int slot = 0; slot < 3; ++slot)
      for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) largest.see(norm(crowd.lab.force(slot, v)));
    CHECK(largest < 1e3);
  }
}

TEST_CASE("Damping acts against approach only, and never pulls") {
  const Mesh ball = makeIcosphere(2);
  const auto pushAt = [&](double approach) {
    Body left = shakenBody(ball, 0, 0), right = left;
    for (Point& x : right.position) x += Vector{1.9, 0, 0};
    for (Vector& u : right.velocity) u = {-approach, 0, 0};
    Crowd crowd(limp(), {ContactLaw::pair, 40, 0.5}, ball, {left, right});
    crowd.evaluateForces();
    Vector push;
    for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) push += crowd.lab.force(1, v);
    return push.x;
  };
  CHECK(pushAt(1) > pushAt(0));
  CHECK(pushAt(0) > pushAt(-1));
  CHECK(pushAt(-1000) == 0);
}

TEST_CASE("Friction acts against the slip and is bounded by Coulomb's cone") {
  const Mesh ball = makeIcosphere(2);
  const auto forceOn = [&](double friction, double slip, double timeStep = 0x1p-30) {
    Body left = shakenBody(ball, 0, 0), right = left;
    for (Point& x : right.position) x += Vector{1.9, 0, 0};
    for (Vector& u : right.velocity) u = {0, slip, 0};
    Crowd crowd(limp(), {ContactLaw::pair, 40, 0, friction, 0.01}, ball, {left, right});
    crowd.lawTimeStep = timeStep;
    crowd.evaluateForces();
    Vector push;
    for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) push += crowd.lab.force(1, v);
    return push;
  };
  const Vector without = forceOn(0, 1), fast = forceOn(0.3, 1), faster = forceOn(0.3, 5),
               slow = forceOn(0.3, 1e-4);
  CHECK(std::abs(without.y) < 1e-12 * without.x);
  CHECK(-fast.y == Approx(0.3 * without.x).epsilon(0.02));  // the cone, but for the curvature of the balls
  CHECK(faster.y == Approx(fast.y).epsilon(1e-9));          // beyond the slip speed it does not grow
  CHECK(slow.y == Approx(fast.y * 0.01).epsilon(1e-3));     // below it fades linearly

  // A step that is too long for so strong a damper: friction grips less, and cannot turn the slip round.
  const double slip = 1e-4, longStep = 0x1p-6;
  const Vector gentle = forceOn(0.3, slip, longStep);
  CHECK(gentle.y < 0);
  CHECK(-gentle.y < 0.5 * -slow.y);
  CHECK(-gentle.y * longStep < slip);  // the right ball's mass is 1
  CHECK(forceOn(0.3, 100, longStep).y ==
        Approx(fast.y).epsilon(1e-9));  // what slips as fast as Coulomb has it is not touched
}
