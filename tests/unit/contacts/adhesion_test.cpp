// Adhesion against its equations, written out for all pairs, and against what they stand for: work per area.
#include <map>
#include <numbers>
#include <set>

#include "catch.h"
#include "crowd.h"

using namespace morula;

namespace {

constexpr double pi = std::numbers::pi;

ContactParameters sticky(double work, double friction = 0, double radius = 1) {
  ContactParameters c{ContactLaw::pair, 40, 0.05, friction, 0.01, radius};
  c.adhesion = AdhesionParameters{work, {}};
  return c;
}

/// [length²] At rest, of each of the cell's vertices in the mean, from the mesh alone.
double restArea(const Bodies& b, int slot) {
  return measureArea(b.mesh.mesh.vertices, b.mesh.mesh.faces) * b.restScale[slot] * b.restScale[slot] /
         b.vertexCount();
}

/// What adhesion adds to the force of j on i, from the equations of pair_law_kernel.h and adhesion.h.
Vector adhesionForce(const SeenVertex& i, const SeenVertex& j, const Bodies& b, double work) {
  const Vector d = i.x - j.x;
  const double inverseSquare = (i.inverseRadiusSquared + j.inverseRadiusSquared) / 2;  // 1/R²
  const double gap = std::max(dot(d, j.normal), -dot(d, i.normal));
  const double near = 1 - dot(d, d) * inverseSquare;
  if (near <= 0 || gap <= 0) return {};
  const double s = 24 / pi * work * restArea(b, i.slot) * restArea(b, j.slot) * inverseSquare * inverseSquare;
  return -s * gap * near * near * ((j.normal - i.normal) / 2.0);
}

std::vector<Vector> forces(Crowd& crowd) {
  crowd.evaluateForces();
  std::vector<Vector> all;
  for (int slot = 0; slot < crowd.lab.bodies.count; ++slot)
    for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) all.push_back(crowd.lab.force(slot, v));
  return all;
}

/// Of two balls at rest, `gap` apart: the pull on the left one. [force]
double pullOf(const Mesh& ball, const ContactParameters& law, double gap, double size = 1, double other = 1) {
  Body left = shakenBody(ball, 0, 0), right = left;
  for (Point& x : left.position) x = size * x;
  for (Point& x : right.position) x = other * x + Vector{size + other + gap, 0.02 * size, 0.03 * size};
  left.restScale = size, right.restScale = other;
  Crowd crowd(limp(), law, ball, {left, right});
  crowd.evaluateForces();
  Vector sum;
  for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) sum += crowd.lab.force(0, v);
  return sum.x;
}

/// [force·length] That parts two balls which touch in a point.
double workToPart(const Mesh& ball, const ContactParameters& law, double reach, double size = 1,
                  double other = 1) {
  constexpr int steps = 60;
  double sum = 0;
  for (int k = 0; k < steps; ++k) sum += pullOf(ball, law, (k + 0.5) * reach / steps, size, other);
  return sum * reach / steps;
}

}  // namespace

TEST_CASE("Adhesion adds to each vertex the sum of its equation over all pairs, by brute force") {
  const Mesh ball = makeIcosphere(1);
  for (const double friction : {0.0, 0.3})
    for (const int count : {2, 3, 9}) {
      const auto cells = heap(ball, count, 2.05, 0.5);
      ContactParameters law = sticky(2, friction), plain = law;
      plain.adhesion.reset();
      Crowd with(limp(), law, ball, cells), without(limp(), plain, ball, cells);
      const std::vector<Vector> a = forces(with), b = forces(without);
      const auto all = seen(with.lab.bodies, law);
      Worst error, largest;
      for (std::size_t k = 0; k < all.size(); ++k) {
        Vector sum;
        for (const SeenVertex& j : all)
          if (all[k].slot != j.slot) sum += adhesionForce(all[k], j, with.lab.bodies, 2);
        error.see(norm(a[k] - b[k] - sum));
        largest.see(norm(sum));
      }
      CAPTURE(friction, count);
      CHECK(largest > 0.1);
      CHECK(error < 1e-5 * largest);  // normals are floats
    }
}

TEST_CASE("On any two cells adhesion is equal and opposite, whatever their sizes") {
  const Mesh ball = makeIcosphere(1);
  for (std::uint32_t key = 0; key < 10; ++key) {
    Crowd crowd(limp(), sticky(3, 0.2), ball, heap(ball, 2, 2.0, 0.5, key));
    crowd.evaluateForces();
    Vector sums[2];
    double size = 0;
    for (int slot : {0, 1})
      for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) {
        sums[slot] += crowd.lab.force(slot, v);
        size += norm(crowd.lab.force(slot, v));
      }
    CAPTURE(key);
    CHECK(size > 0.1);
    CHECK(norm(sums[0] + sums[1]) < 1e-15 * size);
  }
}

TEST_CASE("A pair's two strengths in the list are the same to the bit, and those of its cells' kinds") {
  const Mesh ball = makeIcosphere(1);
  Crowd crowd(limp(), sticky(3), ball, heap(ball, 9, 1.9, 0.5));
  Contacts& c = crowd.contacts;
  AdhesionKinds kinds{{}, 2, {1, 2, 2, 5}};
  for (int slot = 0; slot < 16; ++slot) kinds.ofSlot.push_back(slot / 3 % 2);  // row by row
  setAdhesionKinds(c, kinds);
  crowd.evaluateForces();
  const VertexNumber far = crowd.lab.bodies.lineCount() * blockLanes;
  const int vertices = static_cast<int>(ball.vertices.size());
  const auto slotOf = [&](VertexNumber g) { return g / blockLanes / vertices * blockLanes + g % blockLanes; };
  std::map<std::pair<VertexNumber, VertexNumber>, double> strength;
  for (const NeighbourSlice& slice : c.list.slices)
    for (int lane = 0; lane < blockLanes; ++lane)
      for (int k = 0; k < slice.length; ++k) {
        const std::int64_t at = (slice.start + k) * blockLanes + lane;
        if (c.list.indices[at] == far) CHECK(c.adhesion.ofPairs[at] == 0);
        else strength[{slice.vertex[lane], c.list.indices[at]}] = c.adhesion.ofPairs[at];
      }
  CHECK(strength.size() > 100);
  bool same = true;
  Worst error;
  std::set<double> works;
  for (const auto& [pair, s] : strength) {
    same = same && strength.at({pair.second, pair.first}) == s;
    const int i = slotOf(pair.first), j = slotOf(pair.second);
    const double work = kinds.work[kinds.ofSlot[i] * 2 + kinds.ofSlot[j]];
    works.insert(work);
    const double x = 1 / (c.radius[i] * c.radius[i]), y = 1 / (c.radius[j] * c.radius[j]);
    const double mean = (x + y) / 2;
    error.see(std::abs(s - 24 / pi * work * restArea(crowd.lab.bodies, i) * restArea(crowd.lab.bodies, j) *
                               mean * mean));
  }
  CHECK(same);
  CHECK(error < 1e-12);
  CHECK(works == std::set<double>{1, 2, 5});
}

TEST_CASE("To part surfaces costs W per area, whatever the mesh: two balls pull as spheres do by Derjaguin") {
  // [Derjaguin 1934] F(D) = 2πR* ∫ p(g) dg from D on, R* = ½ for two balls of radius 1. So to part them from where they
  // touch in a point takes 2πR* ∫ g p(g) dg, and with p(g) = 8W (g/R²) (1 − g²/R²)³ of adhesion.h that integral is
  // 8 (1/3 − 3/5 + 3/7 − 1/9) W R = 0.406 W R.
  for (const int level : {2, 3}) {
    const Mesh ball = makeIcosphere(level);
    const double reach = Crowd(limp(), sticky(1), ball, {shakenBody(ball, 0, 0)}).contacts.radius[0];
    CAPTURE(level, reach);
    CHECK(workToPart(ball, sticky(1), reach) == Approx(2 * pi * 0.5 * 0.406 * reach).epsilon(0.15));
    CHECK(workToPart(ball, sticky(2), reach) == Approx(2 * workToPart(ball, sticky(1), reach)));
  }
}

TEST_CASE("Cells of other sizes stick as strongly per area") {
  const Mesh ball = makeIcosphere(3);
  const double reach = Crowd(limp(), sticky(1), ball, {shakenBody(ball, 0, 0)}).contacts.radius[0];
  const double whole = workToPart(ball, sticky(1), reach);
  // All lengths halved: R* and R are half as large, W the same.
  CHECK(workToPart(ball, sticky(1), reach / 2, 0.5, 0.5) == Approx(whole / 4).epsilon(1e-4));
  // One of half the size: R* = 1/3, and the reach goes by the mean of 1/R².
  const double mixed = workToPart(ball, sticky(1), reach, 1, 0.5);
  CHECK(mixed == Approx(2 * pi / 3 * 0.406 * reach * std::sqrt(2.0 / 5)).epsilon(0.25));
}

TEST_CASE(
    "Adhesion begins with nothing where surfaces meet, and ends with nothing where they no longer reach") {
  const Mesh ball = makeIcosphere(1);
  const ContactParameters law = sticky(3);
  double before = pullOf(ball, law, 1), largest = 0, jump = 0;
  CHECK(before == 0);
  for (double gap = 1; gap > -0.1; gap -= 1e-3) {
    const double pull = pullOf(ball, law, gap);
    jump = std::max(jump, std::abs(pull - before));
    largest = std::max(largest, pull);
    before = pull;
  }
  CHECK(largest > 1);
  CHECK(jump < 0.02 * largest);
}

TEST_CASE("The steepest adhesion counts against the time step; without adhesion there is none") {
  const Mesh ball = makeIcosphere(2);
  ContactParameters plain = sticky(2), pairs = sticky(2);
  plain.adhesion.reset();
  pairs.adhesion->pairs.push_back({"a", "b", 4});
  const auto of = [&](const ContactParameters& law, double smaller) {
    Body one = shakenBody(ball, 0, 0), other = one;
    other.restScale = smaller;
    const Crowd crowd(limp(), law, ball, {one, other});
    return adhesionStiffness(crowd.contacts, crowd.lab.bodies);
  };
  CHECK(of(plain, 1) == 0);
  CHECK(of(sticky(2), 1) == Approx(2 * 5.51).epsilon(0.02));
  CHECK(of(pairs, 1) == Approx(4 * 5.51).epsilon(0.02));
  CHECK(of(sticky(2), 0.5) == Approx(2 * 5.51 * 25 / 16).epsilon(0.02));
}

TEST_CASE("Two cells stick with the mean of their own factors") {
  const Mesh ball = makeIcosphere(2);
  Body one = shakenBody(ball, 0, 0), other = one;
  for (Point& x : other.position) x += Vector{2.05, 0, 0};
  const auto pullWith = [&](std::vector<double> factor) {
    Crowd crowd(limp(), sticky(2), ball, {one, other});
    AdhesionKinds kinds{std::vector<int>(8, 0), 1, {2}, std::move(factor)};
    setAdhesionKinds(crowd.contacts, kinds);
    crowd.evaluateForces();
    Vector sum;
    for (int v = 0; v < crowd.lab.bodies.vertexCount(); ++v) sum += crowd.lab.force(0, v);
    return sum.x;
  };
  const double plain = pullWith({});
  CHECK(plain > 0.1);
  CHECK(pullWith(std::vector<double>(8, 1)) == plain);
  CHECK(pullWith({1.5, 0.9, 1, 1, 1, 1, 1, 1}) == Approx(1.2 * plain));
}
