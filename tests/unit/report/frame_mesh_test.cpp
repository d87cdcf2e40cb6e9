// Shapes of cells in frames: coarser ones have the same volume and middle, and lie near the finer surface; spheres have a
// middle and a radius.
#include "report_data/frame_mesh.h"

#include <bit>
#include <cmath>

#include "catch.h"
#include "files/bytes.h"
#include "loop/simulate.h"
#include "mesh/mesh_measures.h"
#include "report_data/frames.h"

namespace morula {
namespace {

/// Returns a dented ellipsoid on an icosphere.
Mesh dentedEgg(int level) {
  Mesh mesh = makeIcosphere(level);
  for (Point& p : mesh.vertices) {
    const double dent = 1 - 0.2 * std::exp(-8 * ((p.x - 1) * (p.x - 1) + p.y * p.y + p.z * p.z));
    p = dent * Vector{1.3 * p.x + 4, 0.9 * p.y, p.z - 2};
  }
  return mesh;
}

Vector meanOf(const std::vector<Point>& points) {
  Vector sum;
  for (const Point& p : points) sum += p;
  return sum / double(points.size());
}

float realAt(const std::string& bytes, std::size_t at) {
  return std::bit_cast<float>(numberAt<std::uint32_t>(bytes, at));
}

}  // namespace

TEST_CASE("Frames of many vertices have levels that fit") {
  CHECK(levelsCoarser(0) == 0);
  CHECK(levelsCoarser(maxDrawnVertices) == 0);
  CHECK(levelsCoarser(maxDrawnVertices + 1) == 1);
  CHECK(levelsCoarser(4096 * 162) == 1);
  CHECK(levelsCoarser(4096 * 642) == 2);
}

TEST_CASE("A coarser shape has the volume and middle of the finer one") {
  for (const int level : {2, 3, 4})
    for (const int levels : {1, 2}) {
      CAPTURE(level, levels);
      const Mesh fine = dentedEgg(level), coarse = coarserShape(fine, levels);
      const int expected = std::max(1, level - levels);
      REQUIRE(coarse.faces == makeIcosphere(expected).faces);
      REQUIRE(coarse.vertices.size() == makeIcosphere(expected).vertices.size());
      CHECK(measureVolume(coarse.vertices, coarse.faces) == Approx(measureVolume(fine.vertices, fine.faces)));
      CHECK(norm(meanOf(coarse.vertices) - meanOf(fine.vertices)) < 1e-12);
    }
}

TEST_CASE("Few vertices and other meshes stay as they are") {
  const Mesh fine = dentedEgg(2);
  CHECK(coarserShape(fine, 0).vertices == fine.vertices);
  const Mesh least = dentedEgg(1);
  CHECK(coarserShape(least, 3).vertices == least.vertices);
  Mesh other = fine;
  std::swap(other.faces[3], other.faces[5]);
  CHECK(coarserShape(other, 1).vertices == other.vertices);
}

TEST_CASE("A sphere in a frame is a middle and a radius, and many have fewer vertices") {
  CHECK(ballFor(1).faces == makeIcosphere(2).faces);
  CHECK(ballFor(maxBallVertices / 162).ball.size() == 162);
  CHECK(ballFor(maxBallVertices / 162 + 1).ball.size() == 42);
  CHECK(placesOf(ballFor(1)) == 0);
  CHECK(placesOf({makeIcosphere(2).faces, {}}) == 162);
  const Scenario scenario = readScenario(
      "morula: 1\nname: two\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 1.25}\n"
      "physics: {cell: {model: sphere, radius: 0.7}, drag: 1, contact: {}}\ndivision: {plane: {axis: [1, 0, 0]}}\n",
      "two.yaml", "");
  FrameTaker taker(1.25, 3);
  const auto run = simulate(scenario, Execution{}, {.watch = {&taker}});
  const Frames& frames = taker.frames();
  REQUIRE(frames.meshes.size() == 1);
  CHECK(frames.coarser == 0);
  const Frame& last = frames.frames.back();
  REQUIRE(last.cells == 2);
  const std::size_t words = 7 + frames.measures.size();
  CHECK(last.bytes.size() == 4 * words * last.cells + 12 * last.contacts);
  for (std::size_t i = 0; i < 2; ++i) {
    const Mesh drawn = cellMesh(run.world, run.world.cells.path[i]);
    const std::size_t at = 4 * words * i;
    const Point middle{realAt(last.bytes, at + 12), realAt(last.bytes, at + 16), realAt(last.bytes, at + 20)};
    // Tolerance: places and radius are floats.
    for (std::size_t v = 0; v < drawn.vertices.size(); ++v)
      CHECK(norm(drawn.vertices[v] - middle) == Approx(realAt(last.bytes, at + 24)).epsilon(1e-6));
  }
}

}  // namespace morula
