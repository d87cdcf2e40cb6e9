// Surfaces that are pushed through themselves, against winding numbers of points.
#include <cmath>
#include <functional>
#include <vector>

#include "catch.h"
#include "self_overlap.h"
#include "zoo.h"

using namespace morula;

namespace {

constexpr double told = 0.0025;  // sanity::maxSelfOverlap
constexpr double planted = 0.005;

/// A place where a line along z meets a surface that leaves the inside upwards (1) or downwards (-1).
struct Meeting {
  double z;
  int up;
};

std::vector<Meeting> meet(const Mesh& m, double x, double y) {
  std::vector<Meeting> all;
  for (const auto& [i, j, k] : m.faces) {
    const Point &a = m.vertices[i], &b = m.vertices[j], &c = m.vertices[k];
    const auto side = [&](const Point& p, const Point& q) { return (p.x - x) * (q.y - y) - (p.y - y) * (q.x - x); };
    const double ab = side(a, b), bc = side(b, c), ca = side(c, a);
    if ((ab > 0) == (bc > 0) && (bc > 0) == (ca > 0))
      all.push_back({(ab * c.z + bc * a.z + ca * b.z) / (ab + bc + ca), ab > 0 ? 1 : -1});
  }
  return all;
}

/// The oracle: returns the share of the space that the surface winds around in which it does so more than once or
/// inside out, at `side`³ points of a lattice. The winding number of a point is the number of faces by which a ray
/// along z leaves, minus those by which it enters.
double sampledSelfOverlap(const Mesh& m, int side) {
  const auto [low, high] = measureBox(m.vertices);
  const Vector step = (high - low) / side;
  int wound = 0, repeated = 0;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const auto meetings = meet(m, low.x + (i + 0.5) * step.x, low.y + (j + 0.5) * step.y);
      for (int k = 0; k < side; ++k) {
        int winding = 0;
        for (const Meeting& at : meetings) winding += at.z > low.z + (k + 0.5) * step.z ? at.up : 0;
        wound += winding != 0;
        repeated += winding != 0 && winding != 1;
      }
    }
  return static_cast<double>(repeated) / wound;
}

/// A way to push a ball into itself, the farther the larger the number.
struct Push {
  std::function<Mesh(double)> shape;
  double least, most;  // at `least` it does not touch itself
};

std::vector<Push> pushes() {
  std::vector<Push> all;
  const auto bend = [&](int level) {
    const Mesh ball = makeIcosphere(level);
    all.push_back({[=](double angle) { return zoo::bent(ball, angle); }, 4, 7});
  };
  const auto dent = [&](int level, double width, double lean) {
    const Mesh ball = makeIcosphere(level);
    all.push_back({[=](double depth) { return zoo::dented(ball, depth, width, lean); }, 1, 3.5});
  };
  bend(2), bend(3), dent(3, 0.16, 0.4);
  for (const double width : {0.16, 0.3, 0.6})
    for (const double lean : {0.0, 0.4}) dent(2, width, lean);
  return all;
}

/// Returns the shape that covers this share of its volume more than once or inside out, by finer lines.
Mesh plant(const Push& push, double share) {
  double low = push.least, high = push.most;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (low + high);
    (selfOverlapOf(push.shape(middle), 64) < share ? low : high) = middle;
  }
  return push.shape(high);
}

}  // namespace

TEST_CASE("A surface pushed through itself is measured as by winding numbers of points") {
  int key = 0;
  for (const Push& push : pushes())
    for (const double share : {planted, 2 * planted}) {
      CAPTURE(key, share);
      const Mesh m = zoo::turned(plant(push, share), ++key);
      // A lattice of 40³ points has 20,000 within the surface: 100 of them in a share of 0.005.
      const double sampled = sampledSelfOverlap(m, 40);
      CHECK(sampled == Approx(share).epsilon(0.2));
      CHECK(selfOverlapOf(m) == Approx(sampled).margin(0.001 + 0.05 * sampled));
    }
}

TEST_CASE("A surface that covers a two-hundredth of its volume twice, or inside out, is told however it lies") {
  int found = 0, tried = 0;
  double least = 1, most = 0;
  for (const Push& push : pushes()) {
    const Mesh m = plant(push, planted);
    for (int turn = 0; turn < 6; ++turn) {
      const Mesh turned = zoo::turned(m, ++tried);
      const double share = selfOverlapOf(turned);
      CHECK(!isStarShaped(turned));
      found += share > told;
      least = std::min(least, share), most = std::max(most, share);
    }
  }
  CAPTURE(least, most);
  CHECK(found == tried);
  CHECK(tried == 54);
  CHECK(most < 1.5 * planted);
}

TEST_CASE("Balls, ellipsoids and star-shaped cells lie nowhere in themselves") {
  std::uint32_t key = 0;
  const auto check = [&](const Mesh& mesh) {
    const Mesh m = zoo::turned(mesh, ++key);
    CAPTURE(key);
    CHECK(selfOverlapOf(m) == Approx(0).margin(1e-12));
  };
  for (int level = 0; level <= 4; ++level) {
    const Mesh ball = makeIcosphere(level);
    check(ball);
    for (const Vector& axes : {Vector{1, 1, 0.02}, Vector{5, 1, 1}, Vector{3, 0.5, 1}}) check(zoo::scaled(ball, axes));
    for (std::uint64_t seed = 1; seed <= 20; ++seed) check(zoo::crumpled(ball, 0.04 * seed, seed));
  }
}
