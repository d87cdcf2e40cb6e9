// Errors between states of known distance.
#include "accuracy/state_error.h"

#include <algorithm>

#include "catch.h"
#include "scenes.h"
#include "unit/mesh/zoo.h"

using namespace morula;

namespace {

ComparedCell cell(const char* path, const Mesh& mesh) { return comparedCell(CellPath::parse(path), mesh); }

}  // namespace

TEST_CASE("The errors of centroid, volume and surface are each the max over the cells, in egg radii or relative") {
  const Mesh cube = scenes::cube();
  const Shapes reference{1, {cell("A", cube), cell("B", zoo::moved(cube, {5, 0, 0}))}};
  Shapes other{
      1, {cell("A", zoo::moved(cube, {0, 0.3, 0.4})), cell("B", zoo::moved(scenes::scaled(cube, 1.1), {5, 0, 0}))}};
  const StateError error = compareShapes(other, reference, 2);
  CHECK(error.centroid == Approx(0.25).epsilon(1e-12));
  CHECK(error.volume == Approx(0.331).epsilon(1e-12));
  CHECK(error.surface > 0.05);
  CHECK(error.surface < 0.25);
  CHECK(error.largest() == error.volume);
}

TEST_CASE("A cell's centroid is that of its volume, wherever its vertices lie") {
  // A half ball has its vertices crowded on the dome; the centroid of its volume lies 3/8 of the radius up.
  Mesh half = makeIcosphere(3);
  for (Point& x : half.vertices) x.z = std::max(x.z, 0.0);
  CHECK(comparedCell({}, half).centroid.z == Approx(0.375).epsilon(0.01));
  CHECK(comparedCell({}, zoo::moved(half, {1e3, 0, 0})).centroid.x == Approx(1e3).epsilon(1e-12));
}

TEST_CASE("States with different cells are recognised, and not compared") {
  const Mesh cube = scenes::cube();
  const Shapes one{0, {cell("", cube)}}, two{0, {cell("A", cube), cell("B", cube)}}, empty{0, {}};
  CHECK(haveSameCells(one, one));
  CHECK_FALSE(haveSameCells(one, two));
  CHECK_FALSE(haveSameCells(empty, two));
  CHECK_THROWS(compareShapes(one, two, 1));
}

TEST_CASE("Births are compared with births of the same path") {
  const std::vector<LineageEntry> a{{CellPath{}, 0, 1, 0, 0, Fate::divided, 0},
                                    {CellPath::parse("A"), 1, 0, 0, 0, Fate::alive, 0},
                                    {CellPath::parse("B"), 1, 0, 0, 0, Fate::alive, 0}};
  auto b = a;
  b[1].born = 1.25;
  b.push_back({CellPath::parse("AA"), 7, 0, 0, 0, Fate::alive, 0});
  CHECK(compareBirths(a, b) == 0.25);
  CHECK(compareBirths(b, a) == 0.25);
  CHECK(compareBirths(a, a) == 0);
}
