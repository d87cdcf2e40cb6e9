// Walls at right angles to the walls before them [Sachs 1877].
#include "base/error.h"
#include "base/random.h"
#include "catch.h"
#include "known_cell.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

/// Returns the vertices of an ellipsoid off the origin, with semi-axes 3, 2 and 1 along x, y and z.
std::vector<Point> brickVertices() { return zoo::moved(zoo::scaled(makeIcosphere(2), {3, 2, 1}), {5, -1, 2}).vertices; }

KnownCell daughter(const std::vector<Point>& vertices, const Vector& motherAxis) {
  KnownCell cell("AB", vertices);
  cell.mother = DivisionRecord{CellPath::parse("A"), 1, 1, motherAxis, 0.5, {}};
  return cell;
}

const auto policy = makeDivisionPolicy({DivisionPlane::alternating, {0, 3, 4}}, 1);

}  // namespace

TEST_CASE("alternating: a cell that no division made is cut across the given axis, through its centre") {
  const Cut cut = policy->findCut(KnownCell("", brickVertices()));
  CHECK(norm(cut.normal - Vector{0, 0.6, 0.8}) < 1e-15);
  CHECK(cut.point == measureCentroid(brickVertices()));
}

TEST_CASE("alternating: of the directions in the mother's plane it is the one of the largest extent") {
  CHECK(norm(policy->findCut(daughter(brickVertices(), {1, 0, 0})).normal - Vector{0, 1, 0}) < 1e-6);
  CHECK(norm(policy->findCut(daughter(brickVertices(), {0, 1, 0})).normal - Vector{1, 0, 0}) < 1e-6);
  CHECK(norm(policy->findCut(daughter(brickVertices(), {0, 0, -1})).normal - Vector{1, 0, 0}) < 1e-6);
}

TEST_CASE("alternating: whatever the mother's axis and the shape, the new one stands at right angles to it") {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Vector axis = randomDirection({seed, {}, 0, Purpose::test});
    const Body shaken = shakenBody(makeIcosphere(1), seed % 2 ? 0.3 : 0, 0, seed);  // a ball for even seeds
    const Cut cut = policy->findCut(daughter(shaken.position, axis));
    CHECK(std::abs(dot(cut.normal, axis)) < 1e-12);
    CHECK(norm(cut.normal) == Approx(1).epsilon(1e-13));
  }
}

TEST_CASE("alternating: who turns the cell and its mother's axis turns the plane") {
  const Vector axis = randomDirection({7, {}, 0, Purpose::test});
  const auto turn = [](const Vector& x) { return Vector{-x.y, x.z, -x.x}; };
  std::vector<Point> turned = brickVertices();
  for (Point& x : turned) x = turn(x);
  const Vector before = policy->findCut(daughter(brickVertices(), axis)).normal;
  const Vector after = policy->findCut(daughter(turned, turn(axis))).normal;
  CHECK(norm(cross(turn(before), after)) < 1e-12);  // equal lines; another rule chooses between their directions
}

TEST_CASE("alternating: a first axis without length is an error") {
  CHECK_THROWS_AS(makeDivisionPolicy({DivisionPlane::alternating, {}}, 1), InputError);
}
