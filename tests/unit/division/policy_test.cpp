// Policies that choose a cell's plane of division.
#include "division/policy.h"

#include <set>

#include "catch.h"
#include "known_cell.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

const Mesh needle = zoo::scaled(makeIcosphere(1), {1, 3, 1});

/// Returns a cell in a shell, for planes that need one.
KnownCell inShell(const char* name) {
  KnownCell cell(name, needle);
  cell.semiAxes = Vector{1, 3, 2};
  return cell;
}

Vector normalOf(const DivisionParameters& p, std::uint64_t seed, const char* cell) {
  return makeDivisionPolicy(p, seed)->findCut(inShell(cell)).normal;
}

}  // namespace

TEST_CASE("A fixed axis is the same for every cell, at unit length") {
  const DivisionParameters p{DivisionPlane::axis, {0, 3, 4}};
  for (const char* cell : {"", "A", "ABBA"}) CHECK(norm(normalOf(p, 1, cell) - Vector{0, 0.6, 0.8}) < 1e-15);
}

TEST_CASE("An axis without direction is an error") {
  CHECK_THROWS_AS(makeDivisionPolicy({DivisionPlane::axis, {0, 0, 0}}, 1), InputError);
  CHECK_THROWS_AS(makeDivisionPolicy({DivisionPlane::axis, {std::nan(""), 0, 0}}, 1), InputError);
}

TEST_CASE("By default a cell divides across its longest extent") {
  CHECK(norm(normalOf({}, 1, "A") - Vector{0, 1, 0}) < 1e-7);
}

TEST_CASE("A random plane is keyed by seed and path, and by nothing else") {
  const DivisionParameters p{DivisionPlane::random, {}};
  const Vector once = normalOf(p, 1, "AB");
  CHECK(norm(once) == Approx(1).epsilon(1e-15));
  CHECK(normalOf(p, 1, "AB") == once);
  CHECK(makeDivisionPolicy(p, 1)->findCut(KnownCell("AB", shakenBody(makeIcosphere(0), 1, 1).position)).normal == once);
  CHECK_FALSE(normalOf(p, 2, "AB") == once);
  CHECK_FALSE(normalOf(p, 1, "BA") == once);
  CHECK_FALSE(normalOf(p, 1, "A") == once);
}

TEST_CASE("Random planes of many cells and seeds look everywhere alike") {
  const DivisionParameters p{DivisionPlane::random, {}};
  constexpr int draws = 4096;
  // Archimedes: the height on a sphere is uniform, so each of eight slices along each axis gets an eighth.
  int slices[3][8] = {};
  for (int i = 0; i < draws; ++i) {
    KnownCell cell("", makeIcosphere(0).vertices);
    for (int bit = 0; bit < 12; ++bit) cell.path = cell.path.daughter(i >> bit & 1);
    const Vector n = makeDivisionPolicy(p, 7)->findCut(cell).normal;
    const double component[3] = {n.x, n.y, n.z};
    for (int axis = 0; axis < 3; ++axis) ++slices[axis][static_cast<int>((component[axis] + 1) * 4)];
  }
  for (const auto& axis : slices) {
    double chiSquare = 0;
    for (int count : axis) chiSquare += (count - draws / 8.0) * (count - draws / 8.0) / (draws / 8.0);
    CHECK(chiSquare < 24.3);  // 7 degrees of freedom: one seed in a thousand exceeds this
  }
}

TEST_CASE("Each way to choose a plane has a row, a name of its own and a policy") {
  std::set<std::string> names;
  for (int i = 0; i < static_cast<int>(divisionPlanes().size()); ++i) {
    const DivisionPlaneKind& kind = kindOf(static_cast<DivisionPlane>(i));
    INFO(kind.name);
    CHECK(names.insert(kind.name).second);
    const DivisionParameters p{kind.plane, {0, 2, 0}};
    CHECK(norm(normalOf(p, 1, "AB")) == Approx(1).epsilon(1e-13));
    CHECK(makeDivisionPolicy(p, 1)->findCut(inShell("AB")).point == measureCentroid(needle.vertices));
    CHECK((normalOf(p, 1, "AB") == normalOf(p, 2, "AB")) != kind.usesSeed);
  }
}
