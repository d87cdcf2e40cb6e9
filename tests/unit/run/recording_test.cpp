// Nothing is measured, hashed or stored unless it is requested.
#include "catch.h"
#include "run/run_scenario.h"
#include "scenario/scenario.h"
#include "store/store.h"
#include "temporary_folder.h"

using namespace morula;

namespace {

const std::string bodies =
    "morula: 1\nname: some\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {time: 1.5}\n"
    "physics: {mesh: {icosphere: 1}, contact: {}}\n";
const std::string genes =
    "morula: 1\nname: some\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cycles: 4}\n";

RunResults stored(const std::string& text) {
  const TemporaryFolder folder;
  RunSettings settings;
  settings.folder = folder.path();
  settings.database = folder / "run.db";
  settings.draw = false;
  settings.quiet = true;
  const auto outcome = runScenario(readScenario(text, "some.yaml", folder.path()), settings);
  REQUIRE(outcome.end.status == RunStatus::done);
  CHECK(outcome.end.stateHash.has_value());
  return Store::openForReading(settings.database).results(outcome.id);
}

}  // namespace

TEST_CASE("A run keeps its lineage and what its scenario asks for, and nothing else") {
  for (const bool withBodies : {true, false}) {
    const std::string text = withBodies ? bodies : genes;
    CAPTURE(text);
    const RunResults plain = stored(text);
    CHECK(plain.lineage.size() >= 3);
    CHECK(plain.samples.size() == 2);  // at the start and at the end
    CHECK(plain.chain.empty());
    CHECK(plain.connections.empty());
    const RunResults sampled = stored(text + "record: {every: 0.5}\n");
    CHECK(sampled.samples.size() == (withBodies ? 4 : 5));
    CHECK(sampled.chain.empty());
    const RunResults checked = stored(text + "check: {}\n");
    CHECK(checked.samples.size() == 2);
    CHECK(checked.chain.size() > 3);
  }
}

TEST_CASE("Where there is a golden file the states are hashed for it, unless it is not looked at") {
  const auto scenario = loadScenario(MORULA_SOURCE_DIR "/scenarios/thesis/elegans-1024.yaml");
  const auto hashes = [&](bool check, bool changed) {
    const TemporaryFolder folder;
    RunSettings settings;
    settings.database = folder / "run.db";
    settings.check = check, settings.changed = changed, settings.draw = false, settings.quiet = true;
    const auto outcome = runScenario(scenario, settings);
    return Store::openForReading(settings.database).results(outcome.id).chain.size();
  };
  CHECK(hashes(true, false) == 13);
  CHECK(hashes(false, false) == 0);
  CHECK(hashes(true, true) == 0);
}
