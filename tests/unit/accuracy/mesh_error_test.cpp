// Mesh errors from manufactured runs of several meshes, and the choice of meshes.
#include "accuracy/mesh_error.h"

#include "catch.h"
#include "reader.h"
#include "scenes.h"
#include "unit/mesh/zoo.h"

using namespace morula;

namespace {

/// Returns a run of one cube, at the origin at time 0 and off by `off` along x at times 1 and 2. Pressure and contact
/// area are off by as much.
Trial run(double off) {
  Trial trial;
  for (int time = 0; time < 3; ++time) {
    Shapes shapes{double(time), {comparedCell({}, zoo::moved(scenes::cube(), {time > 0 ? off : 0, 0, 0}))}};
    shapes.cells[0].pressure = 2 + off;
    ContactMeasures contact{{}, CellPath::parse("A"), CellPath::parse("B")};
    contact["area"] = 1 + off;
    shapes.contacts = {contact};
    trial.shapes.push_back(shapes);
  }
  return trial;
}

}  // namespace

TEST_CASE("Three meshes whose errors quarter tell them exactly; two assume it") {
  // The truth is 0, so errors are 0.16, 0.04 and 0.01.
  const Trial one = run(0.16), two = run(0.04), three = run(0.01);
  const MeshError all = estimateMeshError({{1, &one}, {2, &two}, {3, &three}}, 1, 1);
  CHECK(all.orderIsObserved);
  CHECK(all.order == Approx(2));
  CHECK(all.find(1)->worst.centroid == Approx(0.16));
  CHECK(all.find(2)->atEnd.centroid == Approx(0.04));
  CHECK(all.find(3)->worst.centroid == Approx(0.01));
  CHECK(all.find(1)->worst.volume == 0);
  CHECK(all.find(1)->worst.contactArea == Approx(0.16).epsilon(0.02));
  CHECK(*all.error() >= all.find(1)->worst.centroid * (1 - 1e-12));
  CHECK(*all.errorOf(4) == Approx(*all.errorOf(3) / 4));
  CHECK(all.until == 2);
  CHECK(all.unknown.empty());

  const MeshError pair = estimateMeshError({{1, &one}, {2, &two}}, 2, 1);
  CHECK_FALSE(pair.orderIsObserved);
  CHECK(pair.find(2)->worst.centroid == Approx(0.04));
  CHECK_FALSE(pair.errorOf(0));
}

TEST_CASE("Meshes that do not come closer have no order, and at least the largest distance for an error") {
  const Trial one = run(0.1), two = run(0.2), three = run(0);
  const MeshError error = estimateMeshError({{1, &one}, {2, &two}, {3, &three}}, 2, 1);
  CHECK(error.order == 0);
  CHECK(error.find(2)->worst.centroid >= 0.2 * (1 - 1e-15));  // rounding of 0.3 − 0.1
  CHECK_FALSE(error.errorOf(4));
}

TEST_CASE("Where other cells live on another mesh, errors are those up to then") {
  const Trial one = run(0.1), two = run(0.05);
  Trial three = run(0);
  three.shapes[2].cells[0].path = CellPath::parse("A");
  const MeshError error = estimateMeshError({{1, &one}, {2, &two}, {3, &three}}, 1, 1);
  CHECK(error.partedAt == 2.0);
  CHECK(error.until == 1);
  CHECK(error.unknown.empty());
  three.shapes[1].cells[0].path = CellPath::parse("A");
  CHECK_FALSE(estimateMeshError({{1, &one}, {2, &two}, {3, &three}}, 1, 1).error());
}

TEST_CASE("A finer mesh that costs more than is allowed takes no part, and the reason is told") {
  const auto read = reader(
      "morula: 1\nname: one\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 0.5}\nphysics:\n  drag: 4\n"
      "  mesh: {icosphere: 2}\n  membrane: {stiffness: 10, damping: 0.02}\n  pressure: {constant: 8, outside: 0}\n");
  AccuracyOptions options;
  options.brief = true;
  options.budget = 1e-6;
  const MeshError none = measureAccuracy(read, options).mesh;
  CHECK_FALSE(none.error());
  CHECK_THAT(none.unknown, ContainsSubstring("icosphere 3 takes about") && ContainsSubstring("--budget"));
  options.budget = 60;
  const AccuracyReport report = measureAccuracy(read, options);
  CHECK(report.mesh.error());
  CHECK(report.rows.empty());
  CHECK(report.own.resolved);
  CHECK(report.own.parts.sum() >= *report.mesh.error());
}

TEST_CASE("The first division across another plane is found, with how round its mother was") {
  const auto division = [](const char* path, double time, const Vector& axis) {
    return DivisionRecord{CellPath::parse(path), time, 1, axis, 0.5, 1.001};
  };
  const std::vector<DivisionRecord> there{division("", 1, {1, 0, 0}), division("A", 2, {0, 1, 0})};
  CHECK_FALSE(findDividedElsewhere(there, there));
  const std::vector<DivisionRecord> here{division("", 1, {1, 0, 0}), division("A", 2, {0, 0.6, 0.8})};
  const auto cut = findDividedElsewhere(here, there);
  REQUIRE(cut);
  CHECK(cut->mother == CellPath::parse("A"));
  CHECK(cut->time == 2);
  CHECK(cut->angle == Approx(53.13).epsilon(1e-3));
  CHECK(cut->extentRatio == 1.001);
  // The plane is the same, with the daughters exchanged.
  const auto turned = findDividedElsewhere(std::vector{division("", 1, {-1, 0, 0})}, there);
  REQUIRE(turned);
  CHECK(turned->angle == Approx(180));
  CHECK_FALSE(findDividedElsewhere({}, there));
}
