// Daughter A lies on the side that the axis points to, for every way to choose an axis.
#include <array>

#include "base/random.h"
#include "catch.h"
#include "division/cut.h"
#include "division/policy.h"
#include "known_cell.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

const Mesh& egg() {
  static const Mesh mesh = makeIcosphere(2);
  return mesh;
}

/// Returns the egg, 1 + stretch times as long along a unit direction, off the origin.
Body longCell(const Vector& along, double stretch) {
  Body body = shakenBody(egg(), 0, 0);
  for (Point& x : body.position) x += stretch * dot(x, along) * along + Vector{0.3, -0.2, 0.1};
  return body;
}

/// Returns the vector from daughter B's centre to daughter A's.
Vector fromBToA(const Body& mother, const Vector& normal) {
  const CutResult cut = cutBody(mother, egg().faces, {measureCentroid(mother.position), normal}, 1.26);
  REQUIRE(cut.failure.empty());
  return measureCentroid(cut.daughters.a.position) - measureCentroid(cut.daughters.b.position);
}

Vector axisOf(const DivisionParameters& p, const Body& mother, const char* cell = "AB") {
  return makeDivisionPolicy(p, 7)->findCut(KnownCell(cell, mother.position)).normal;
}

const std::array<Vector, 7> directions{
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}, {0.6, -0.8, 0}, {-0.48, 0.6, 0.64}}};

}  // namespace

TEST_CASE("a fixed axis points to daughter A, and the opposite axis exchanges the daughters") {
  for (const Vector& axis : directions) {
    const Body mother = longCell({0, 0.6, 0.8}, 0.3);
    const Vector normal = axisOf({DivisionPlane::axis, 5 * axis}, mother);
    CHECK(norm(normal - axis) < 1e-15);
    CHECK(dot(fromBToA(mother, normal), axis) > 0.1);
    CHECK(norm(fromBToA(mother, -normal) + fromBToA(mother, normal)) < 1e-12);
  }
}

TEST_CASE("a random axis points to daughter A") {
  for (const char* cell : {"", "A", "B", "ABBA"}) {
    const Body mother = longCell({1, 0, 0}, 0);
    const Vector normal = axisOf({DivisionPlane::random, {}}, mother, cell);
    CHECK(normal == randomDirection({7, CellPath::parse(cell), 0, Purpose::divisionPlane}));
    CHECK(dot(fromBToA(mother, normal), normal) > 0.1);
  }
}

// The longest extent is a line, and a rule must choose its direction: the axis has a positive x + 0.55 y + 0.2 z. Along
// coordinate axes this is the positive direction.
TEST_CASE("across the longest extent daughter A lies on the side of (1, 0.55, 0.2)") {
  for (const Vector& along : directions)
    for (const double sign : {1.0, -1.0}) {
      const Body mother = longCell(sign * along, 1);
      const Vector normal = axisOf({}, mother);
      CAPTURE(along.x, along.y, along.z, sign);
      CHECK(norm(cross(normal, along)) < 1e-6);
      CHECK(normal.x + 0.55 * normal.y + 0.2 * normal.z > 0.02);
      CHECK(dot(fromBToA(mother, normal), normal) > 0.1);
    }
}

TEST_CASE("rounding does not decide which daughter is A, not even of a round cell") {
  for (const double stretch : {0.0, 1e-9, 1.0})
    for (const Vector& along : directions) {
      const Body mother = longCell(along, stretch);
      const Vector normal = axisOf({}, mother);
      for (std::uint32_t i = 0; i < 20; ++i) {
        Body again = mother;
        for (std::uint32_t k = 0; k < again.position.size(); ++k) again.position[k] += 1e-15 * noiseVector(k, i);
        CHECK(norm(axisOf({}, again) - normal) < 1e-5);
      }
    }
  CHECK(norm(axisOf({}, longCell({0, 0, 1}, 0)) - Vector{1, 0, 0}) < 1e-9);
}

TEST_CASE("of a sphere cut in halves too, daughter A lies where the axis points") {
  const Body mother = longCell({1, 0, 0}, 0);
  for (const Vector& axis : directions) {
    const Daughters d = divideSphere(mother, 1, {{}, axis});
    CHECK(dot(d.a.position[0] - d.b.position[0], axis) > 0.1);
  }
}
