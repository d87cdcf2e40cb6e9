// Frames of a run: positions as good as promised, evenly over time, and thinned from the front.
#include "report_data/frames.h"

#include <bit>
#include <cmath>

#include "catch.h"
#include "loop/simulate.h"
#include "simulation/measures.h"

namespace morula {
namespace {

const char* const scene = R"(morula: 1
name: two
dna: |
  START: a0
  g1(divide|a0)
stop: {time: 1.25}
physics: {mesh: {icosphere: 1}, contact: {}}
connections: {make: at-division}
)";

std::uint32_t numberAt(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (int i = 3; i >= 0; --i)
    number = number << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return number;
}

float realAt(const std::string& bytes, std::size_t at) { return std::bit_cast<float>(numberAt(bytes, at)); }

struct Watched {
  Simulation run;
  Frames frames;
};

Watched watch(std::size_t most) {
  const Scenario scenario = readScenario(scene, "two.yaml", "");
  FrameTaker taker(1.25, most);
  auto run = simulate(scenario, Execution{}, {.watch = [&](const World& w) { taker.observe(w); }});
  return {std::move(run), std::move(taker.frames())};
}

TEST_CASE("Frames lie evenly over time, the first at the start and the last at the end") {
  const auto [run, frames] = watch(6);
  REQUIRE(run.end.status == RunStatus::done);
  REQUIRE(frames.frames.size() == 6);
  for (std::size_t k = 0; k < 6; ++k) CHECK(frames.frames[k].time == Approx(0.25 * double(k)).margin(0.02));
  CHECK(frames.frames[0].time == 0);
  CHECK(frames.frames[5].time == run.end.time);
  CHECK(frames.frames[3].cells == 1);
  CHECK(frames.frames[5].cells == 2);
  CHECK(frames.frames[5].connections == 1);
  CHECK(frames.worlds.size() == 6);
}

TEST_CASE("A frame holds measures, and positions within half a step") {
  const auto [run, frames] = watch(2);
  const Frame& last = frames.frames.back();
  const std::size_t words = 9 + frames.measures.size(), vertices = 42;
  REQUIRE(frames.meshes.size() == 1);
  REQUIRE(last.cells == 2);
  const auto cells = measureCells(run.world);
  std::size_t places = 4 * words * last.cells + 12 * last.contacts + 8 * last.connections;
  REQUIRE(last.bytes.size() == (places + 6 * vertices * last.cells + 3) / 4 * 4);
  for (std::size_t i = 0; i < last.cells; ++i) {
    const std::size_t at = 4 * words * i;
    CHECK(run.world.lineage.entries[numberAt(last.bytes, at)].path == run.world.cells.path[i]);
    for (std::size_t m = 0; m < frames.measures.size(); ++m)
      if (const auto& value = cells[i].values[m])
        CHECK(realAt(last.bytes, at + 36 + 4 * m) == static_cast<float>(*value));
    for (const Point& p : cellVertices(run.world, run.world.cells.path[i]))
      for (std::size_t axis = 0; axis < 3; ++axis, places += 2) {
        const double step = realAt(last.bytes, at + 24 + 4 * axis);
        const int number =
            static_cast<unsigned char>(last.bytes[places]) | static_cast<unsigned char>(last.bytes[places + 1]) << 8;
        const double exact = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
        // Half a step, and the rounding of `low` and `step` to float: 2^-24 of the coordinate and of the box.
        CHECK(std::abs(realAt(last.bytes, at + 12 + 4 * axis) + step * number - exact) <=
              0.5 * step + 3 * 6e-8 * (1 + std::abs(exact)));
      }
  }
}

TEST_CASE("What does not fit is thinned, and the last frame stays longest") {
  auto frames = watch(9).frames;
  const std::size_t all = bytesOf(frames);
  thinFrames(frames, all);
  CHECK(frames.frames.size() == 9);
  const double last = frames.frames.back().time;
  thinFrames(frames, all - 1);
  CHECK(frames.frames.size() == 8);
  CHECK(bytesOf(frames) < all);
  CHECK(frames.frames.front().time == 0);
  CHECK(frames.frames.back().time == last);
  thinFrames(frames, frames.frames.back().bytes.size());
  REQUIRE(frames.frames.size() == 1);
  CHECK(frames.frames.back().time == last);
  thinFrames(frames, 10);
  CHECK(frames.frames.empty());
  CHECK(frames.worlds.size() == 9);
}

}  // namespace
}  // namespace morula
