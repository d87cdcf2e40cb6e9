// Faces that a cut folds over are unfolded, and the others stay.
#include "catch.h"
#include "cuts.h"
#include "division/cut.h"
#include "division/halves.h"

using namespace morula;

namespace {

/// Returns a cell pressed in on one side, as by a neighbour: it is not convex, but its projection is a disc.
Mesh dented(double depth) {
  Mesh m = makeIcosphere(2);
  for (Point& v : m.vertices)
    if (v.x > 0) v.x *= 1 - depth * std::max(0.0, 1 - 1.5 * (v.y * v.y + v.z * v.z));
  return m;
}

}  // namespace

TEST_CASE("A convex body has no folds, and none of its vertices moves within the plane") {
  const Mesh mesh = zoo::scaled(makeIcosphere(2), {2, 1, 1});
  std::vector<Point> x = mesh.vertices;
  std::vector<char> flat(x.size());
  for (std::size_t v = 0; v < x.size(); ++v)
    if (x[v].x < 0) flat[v] = true, x[v].x = 0;
  const std::vector<Point> before = x;
  CHECK(countFolds(x, mesh.faces, flat, {-1, 0, 0}) == 0);
  CHECK(unfold(x, mesh.faces, flat, {-1, 0, 0}) == 0);
  CHECK(x == before);
}

TEST_CASE("A crumpled side unfolds, within its plane, and the other side stays") {
  const Mesh mesh = makeIcosphere(2);
  std::vector<Point> x = mesh.vertices;
  std::vector<char> flat(x.size());
  for (std::uint32_t v = 0; v < x.size(); ++v)
    if (x[v].x < -0.4) {
      flat[v] = true;
      x[v] += 0.3 * noiseVector(v);
      x[v].x = 0;
    }
  const std::vector<Point> before = x;
  REQUIRE(countFolds(x, mesh.faces, flat, {-1, 0, 0}) > 3);
  CHECK(unfold(x, mesh.faces, flat, {-1, 0, 0}) == 0);
  CHECK(countFolds(x, mesh.faces, flat, {-1, 0, 0}) == 0);
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (!flat[v]) CHECK(x[v] == before[v]);
    else CHECK(x[v].x == 0);
  }
}

TEST_CASE("Daughters of a dented cell have no folded face") {
  int folded = 0;
  for (double depth : {0.3, 0.5}) {
    const Mesh mesh = dented(depth);
    const Body mother = shakenBody(mesh, 0, 0);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Vector normal = randomDirection({seed, {}, 0, Purpose::test});
      const CutResult cut = cutBody(mother, mesh.faces, throughMean(mother, normal), 1.26);
      CAPTURE(depth, seed);
      REQUIRE(cut.failure == "");
      CHECK(foldsOf(cut.daughters.a, mother, mesh, normal, false) == 0);
      CHECK(foldsOf(cut.daughters.b, mother, mesh, normal, true) == 0);
      folded += projectionFolds(mother, mesh, normal) > 0;
      CHECK(cut.daughters.a.mass + cut.daughters.b.mass == Approx(1).epsilon(1e-15));
    }
  }
  CHECK(folded > 15);
}

TEST_CASE("Of a crater some folds may stay, but far fewer than projection makes") {
  const Mesh mesh = dented(0.9);
  const Body mother = shakenBody(mesh, 0, 0);
  int left = 0, projected = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Vector normal = randomDirection({seed, {}, 0, Purpose::test});
    const CutResult cut = cutBody(mother, mesh.faces, throughMean(mother, normal), 1.26);
    left +=
        foldsOf(cut.daughters.a, mother, mesh, normal, false) + foldsOf(cut.daughters.b, mother, mesh, normal, true);
    projected += projectionFolds(mother, mesh, normal);
  }
  CHECK(left < projected / 4);
}
