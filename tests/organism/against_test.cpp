// The worm's embryo compared with tables of its real cells: the distances are those of check.reference.
#include "check/against.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "catch.h"
#include "files/read_file.h"
#include "observation/organism_measures.h"
#include "simulation/simulation.h"

using namespace morula;

namespace {

Scenario wormWith(const std::string& reference = "real/15.txt") {
  return loadScenario(MORULA_SOURCE_DIR "/scenarios/worm/embryo.yaml",
                      {parseOverride("check.reference.file=" + reference)});
}

struct RealStage {
  int cells;
  double middle;  // [time] as tests/organism/embryo_test.cpp compares
  Reference real;
};

}  // namespace

TEST_CASE("stages of 4, 8, 12 and 15 cells lie as far from tables as from check.reference") {
  std::vector<RealStage> stages;
  for (const auto& [cells, middle] : {std::pair(4, 7.6), std::pair(8, 12.0), std::pair(12, 13.8), std::pair(15, 16.7)})
    stages.push_back({cells, middle, *wormWith(fmt::format("real/{}.txt", cells)).check.reference});
  const Scenario scenario = wormWith();
  // The table holds these places and times, in micrometres and minutes.
  std::string table = "time,name,x,y,z\n";
  const Units& u = scenario.units;
  for (const RealStage& stage : stages)
    for (const auto& [path, p] : stage.real.positions)
      table += fmt::format("{:.17g},{},{:.17g},{:.17g},{:.17g}\n", stage.middle * u.perTime, *scenario.names.of(path),
                           p.x * u.perLength, p.y * u.perLength, p.z * u.perLength);
  const auto byTime = tracks::readMeasured(table, "real.csv", scenario.names, u, {});
  REQUIRE(byTime.stages.size() == stages.size());
  // positions.csv holds the mean places from which real/N.txt was written: posterior, ventral and a third axis [µm].
  const std::string shared = MORULA_SOURCE_DIR "/../shared/celegans/positions.csv";
  const bool isThere = std::filesystem::exists(shared);
  if (!isThere) WARN("skipped: ../shared/celegans is not here");
  tracks::MeasuredCells byCells;
  if (isThere)
    byCells = tracks::readMeasured(readFile(shared), shared, scenario.names, u,
                                   {.columns = {{"x", "posterior_um"}, {"y", "ventral_um"}, {"z", "third_um"}}});

  World world = makeWorld(scenario.scene);
  Against times(byTime.stages), numbers(byCells.stages);
  std::vector<PositionsCompared> expected;
  times.see(world), numbers.see(world);
  while (world.cells.path.size() <= 15) {
    step(world);
    times.see(world), numbers.see(world);
    if (expected.size() == stages.size() || world.clock.time < stages[expected.size()].middle) continue;
    Observation now(world);
    now.reference = &stages[expected.size()].real;
    expected.push_back(comparePositions(now).value());
  }
  const auto found = times.take(world), foundByNumber = numbers.take(world);
  REQUIRE(expected.size() == stages.size());
  REQUIRE(found.size() == stages.size());
  for (std::size_t i = 0; i < stages.size(); ++i) {
    CAPTURE(stages[i].cells);
    CHECK(found[i].cells == static_cast<std::uint64_t>(stages[i].cells));
    CHECK(found[i].compared == expected[i].cells);
    CHECK(found[i].rmsd.value() == Approx(expected[i].distance).epsilon(1e-12));
    CHECK(found[i].scale.value() == Approx(expected[i].scale).epsilon(1e-12));
  }
  // The bound allows for places to 0.001 radii, an egg of 17.02 instead of 17.05 µm, and another middle of the stage.
  for (const AgainstStage& stage : foundByNumber)
    for (std::size_t i = 0; i < stages.size(); ++i)
      if (stage.ofCells == static_cast<std::uint64_t>(stages[i].cells)) {
        CAPTURE(stages[i].cells, *stage.time);
        CHECK(std::abs(*stage.time - stages[i].middle) < 0.3);
        CHECK(*stage.rmsd == Approx(expected[i].distance).margin(0.02));
      }
}
