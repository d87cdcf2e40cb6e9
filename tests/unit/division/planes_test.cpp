// Planes that depend on contacts, polarity, the shell, the organism's surface and connections. Cells are put together
// by hand, and expected directions follow from the arrangement.
#include <algorithm>
#include <functional>

#include "base/error.h"
#include "catch.h"
#include "known_cell.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

/// Returns an ellipsoid with semi-axes 3, 2 and 1 along x, y and z about a point.
Mesh brick(const Vector& at = {}) { return zoo::moved(zoo::scaled(makeIcosphere(1), {3, 2, 1}), at); }

KnownCell other(const Point& at, const char* held) {
  KnownCell cell("B", zoo::moved(makeIcosphere(1), at));
  cell.held = held;
  return cell;
}

PlaneChoice choose(DivisionPlane plane, const char* substance = "") {
  PlaneChoice choice;
  choice.plane = plane;
  choice.substance = substance;
  return choice;
}

Vector normalOf(const PlaneChoice& choice, const CellContext& cell) {
  const Cut cut = makePlanePolicy(choice, 1)->findCut(cell);
  CHECK(cut.point == cell.physical()->getShape().centre);
  CHECK(norm(cut.normal) == Approx(1).epsilon(1e-13));
  return cut.normal;
}

const Vector longest{1, 0, 0};  // longest axis of the brick

}  // namespace

TEST_CASE("towards, away-from: the sum of the directions to those that hold it, each by its contact's area") {
  const KnownCell up = other({0, 0, 4}, "a1 skin"), right = other({0, 8, 0}, "skin a2"),
                  stranger = other({-9, 0, 0}, "a1");
  KnownCell cell("A", brick());
  cell.touched = {{&up, 3}, {&right, 4}, {&stranger, 100}};
  const Vector expected{0, 0.8, 0.6};  // distances do not matter
  CHECK(norm(normalOf(choose(DivisionPlane::towards, "skin"), cell) - expected) < 1e-14);
  CHECK(norm(normalOf(choose(DivisionPlane::towards, "sk*"), cell) - expected) < 1e-14);
  CHECK(norm(normalOf(choose(DivisionPlane::awayFrom, "skin"), cell) + expected) < 1e-14);
  CHECK(norm(normalOf(choose(DivisionPlane::towards, "a2"), cell) - Vector{0, 1, 0}) < 1e-14);
}

TEST_CASE("across: in the contact's plane, along the largest extent there") {
  const KnownCell above = other({0, 0, 4}, "skin"), right = other({9, 0, 0}, "skin");
  KnownCell cell("A", brick());
  cell.touched = {{&above, 3}};
  CHECK(norm(normalOf(choose(DivisionPlane::across, "skin"), cell) - Vector{1, 0, 0}) < 1e-6);
  cell.touched = {{&right, 3}};
  CHECK(norm(normalOf(choose(DivisionPlane::across, "skin"), cell) - Vector{0, 1, 0}) < 1e-6);
}

TEST_CASE("towards, away-from, across: without such a contact, or with contacts all around, as longest") {
  const KnownCell up = other({0, 0, 4}, "skin"), down = other({0, 0, -4}, "skin"),
                  stranger = other({0, 9, 0}, "skinny");
  for (const DivisionPlane plane : {DivisionPlane::towards, DivisionPlane::awayFrom, DivisionPlane::across}) {
    KnownCell cell("A", brick());
    CHECK(norm(normalOf(choose(plane, "skin"), cell) - longest) < 1e-6);
    cell.touched = {{&stranger, 1}};  // a substance must match by its whole name
    CHECK(norm(normalOf(choose(plane, "skin"), cell) - longest) < 1e-6);
    cell.touched = {{&up, 2}, {&down, 2 * (1 + 1e-12)}};
    CHECK(norm(normalOf(choose(plane, "skin"), cell) - longest) < 1e-6);
  }
}

TEST_CASE("polarity: the egg has the given one, daughters what their ancestor left") {
  PlaneChoice choice = choose(DivisionPlane::polarity);
  choice.axis = {0, 3, 4};
  KnownCell egg("", brick());
  const Cut first = makePlanePolicy(choice, 1)->findCut(egg);
  CHECK(norm(first.normal - Vector{0, 0.6, 0.8}) < 1e-15);
  REQUIRE(first.polarity);
  CHECK(*first.polarity == first.normal);
  KnownCell daughter("A", brick());
  daughter.polarity = Vector{0, 0, -1};
  CHECK(normalOf(choice, daughter) == Vector{0, 0, -1});
  choice.axis = {0, 0, 0};
  CHECK_THROWS_AS(makePlanePolicy(choice, 1), InputError);
}

TEST_CASE("polarity: it turns to the contact, or away from it, and stays so; without a contact it stays") {
  PlaneChoice choice = choose(DivisionPlane::polarity, "ems");
  const KnownCell above = other({0, 0, 4}, "ems"), stranger = other({0, 9, 0}, "ab");
  KnownCell cell("A", brick());
  cell.polarity = Vector{0, 1, 0};
  cell.touched = {{&stranger, 1}};
  CHECK(normalOf(choice, cell) == Vector{0, 1, 0});
  cell.touched.push_back({&above, 1});
  for (const bool away : {false, true}) {
    choice.turnsAway = away;
    const Cut cut = makePlanePolicy(choice, 1)->findCut(cell);
    CHECK(norm(cut.normal - Vector{0, 0, away ? -1.0 : 1.0}) < 1e-14);
    CHECK(cut.polarity == cut.normal);
  }
}

TEST_CASE("shell-axis: the longest semi-axis; of equal ones the first") {
  KnownCell cell("A", brick());
  const std::pair<Vector, Vector> cases[] = {{{3, 2, 1}, {1, 0, 0}}, {{1, 2, 1}, {0, 1, 0}}, {{1, 2, 3}, {0, 0, 1}},
                                             {{2, 2, 1}, {1, 0, 0}}, {{1, 2, 2}, {0, 1, 0}}, {{2, 1, 2}, {1, 0, 0}}};
  for (const auto& [semiAxes, axis] : cases) {
    cell.semiAxes = semiAxes;
    CHECK(normalOf(choose(DivisionPlane::shellAxis), cell) == axis);
  }
}

TEST_CASE("perpendicular: away from the organism's centre, or along the shell's normal, with A outside") {
  KnownCell cell("A", brick({3, 4, 0}));
  CHECK(norm(normalOf(choose(DivisionPlane::perpendicular), cell) - Vector{0.6, 0.8, 0}) < 1e-14);
  cell.middle = {3, 0, 0};
  CHECK(norm(normalOf(choose(DivisionPlane::perpendicular), cell) - Vector{0, 1, 0}) < 1e-14);
  // The shell's slope is (3/2², 4/1², 0) = (0.75, 4, 0); with a shell the organism's centre does not matter.
  cell.semiAxes = Vector{2, 1, 1};
  const Vector slope{0.75, 4, 0};
  CHECK(norm(normalOf(choose(DivisionPlane::perpendicular), cell) - slope / norm(slope)) < 1e-14);
}

TEST_CASE("perpendicular in a shell that is a mesh: along the normal of its nearest face, except in the middle") {
  KnownCell cell("A", brick({3, 4, 0})), middle("A", brick({0, 0, 0}));
  cell.middle = cell.physical()->getShape().centre;  // does not matter with a shell
  cell.faceNormal = middle.faceNormal = Vector{0, 0.6, -0.8};
  CHECK(normalOf(choose(DivisionPlane::perpendicular), cell) == Vector{0, 0.6, -0.8});
  CHECK(normalOf(choose(DivisionPlane::perpendicular), middle) == normalOf(choose(DivisionPlane::longest), middle));
}

TEST_CASE("parallel: along the surface, the largest extent there") {
  KnownCell above("A", brick({0, 0, 9})), right("A", brick({9, 0, 0}));
  CHECK(norm(normalOf(choose(DivisionPlane::parallel), above) - Vector{1, 0, 0}) < 1e-6);
  CHECK(norm(normalOf(choose(DivisionPlane::parallel), right) - Vector{0, 1, 0}) < 1e-6);
}

TEST_CASE("perpendicular, parallel: a cell in the middle has no outside, whatever rounding says") {
  for (const DivisionPlane plane : {DivisionPlane::perpendicular, DivisionPlane::parallel})
    for (const Vector& off : {Vector{}, Vector{0, 0, 1e-15}, Vector{0, -0.01, 0}}) {
      KnownCell cell("", brick(off));
      CHECK(norm(normalOf(choose(plane), cell) - longest) < 1e-6);
      cell.semiAxes = Vector{9, 5, 5};
      CHECK(norm(normalOf(choose(plane), cell) - longest) < 1e-6);
    }
}

TEST_CASE("tension: along the strongest pull, also where pulls to opposite sides add up to none") {
  const KnownCell up = other({0, 0, 4}, ""), down = other({0, 0, -7}, ""), right = other({0, 5, 0}, "");
  KnownCell cell("A", brick());
  CHECK(norm(normalOf(choose(DivisionPlane::tension), cell) - longest) < 1e-6);
  cell.holdsOnTo = {&right};
  CHECK(norm(normalOf(choose(DivisionPlane::tension), cell) - Vector{0, 1, 0}) < 1e-14);
  cell.holdsOnTo = {&up, &down, &right};
  CHECK(norm(normalOf(choose(DivisionPlane::tension), cell) - Vector{0, 0, 1}) < 1e-14);
}

// Planes turn with everything that they depend on: one scene without symmetry has all of it.
TEST_CASE("planes turn and are mirrored with what they go by, and the order of neighbours does not matter") {
  const auto turn = [](const Vector& x) { return Vector{-x.y, x.z, -x.x}; };
  const auto mirror = [](const Vector& x) { return Vector{x.x, -x.y, x.z}; };
  const auto same = [](const Vector& x) { return x; };
  const Body lump = shakenBody(makeIcosphere(1), 0.2, 0, 5);
  const auto normalIn = [&](const PlaneChoice& given, const std::function<Vector(const Vector&)>& image, bool mirrored,
                            bool reversed) {
    const auto imageOf = [&](const Point& at, double stretch) {
      Mesh mesh{lump.position, makeIcosphere(1).faces};
      for (Point& x : mesh.vertices) x = image(Vector{stretch * x.x, x.y, x.z} + at);
      if (mirrored)
        for (Face& face : mesh.faces) std::swap(face[1], face[2]);
      return mesh;
    };
    KnownCell one("B", imageOf({3, 1, 0}, 1)), two("BA", imageOf({0, -1, 2}, 1));
    one.held = two.held = "skin";
    KnownCell cell("A", imageOf({0.2, 0.5, 0.3}, 1.4));
    cell.touched = {{&one, 2}, {&two, 1}};
    cell.holdsOnTo = {&one, &two};
    if (reversed) std::ranges::reverse(cell.touched), std::ranges::reverse(cell.holdsOnTo);
    cell.middle = image({1, 1, 1});
    cell.mother = DivisionRecord{CellPath{}, 1, 1, image({0.6, 0, 0.8}), 0.5, {}};
    cell.polarity = image({0.6, 0.64, 0.48});
    PlaneChoice choice = given;
    choice.axis = image(given.axis);
    return normalOf(choice, cell);
  };
  for (const DivisionPlaneKind& kind : divisionPlanes()) {
    if (kind.usesSeed || kind.needsLongShell) continue;
    INFO(kind.name);
    PlaneChoice choice = choose(kind.plane, "skin");
    choice.axis = {0.48, 0.6, 0.64};
    const Vector before = normalIn(choice, same, false, false);
    CHECK(norm(cross(normalIn(choice, turn, false, false), turn(before))) < 1e-3);
    CHECK(norm(cross(normalIn(choice, mirror, true, false), mirror(before))) < 1e-3);
    CHECK(norm(cross(normalIn(choice, same, false, true), before)) < 1e-12);
  }
}
