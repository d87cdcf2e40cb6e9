// morula review --into-golden and --stated, as users start them.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

namespace {

const std::string swings =
    "morula: 1\nname: swinging\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 1}\n"
    "physics:\n  mesh: {icosphere: 1}\n  membrane: {stiffness: 10, damping: 0.02}\n"
    "  pressure: {constant: 8, outside: 0}\n  drag: 4\n";

/// Runs review --into-golden outside of continuous integration, where goldens may be written.
Launched intoGolden(const Words& words) {
  return launch(joined({"review", "--into-golden", "--quiet"}, words), {{"CI", ""}});
}

}  // namespace

TEST_CASE("review --into-golden states the error of the scenario as it is, and of no other") {
  const TemporaryFolder folder;
  const std::string scenario = folder / "swinging.yaml", golden = folder / "swinging.golden";
  writeWhole(scenario, swings);
  CHECK(intoGolden({scenario}).code == 3);  // no golden yet
  accept(scenario);
  CHECK_THAT(readWhole(golden), !ContainsSubstring("\nerror "));
  const auto run = intoGolden({scenario});
  CAPTURE(run.err);
  REQUIRE(run.code == 0);
  CHECK(run.out.find("as it is   error ") != std::string::npos);
  CHECK_THAT(run.out, ContainsSubstring("at rest and at worst"));
  CHECK_THAT(readWhole(golden), ContainsSubstring("\nerror position ") && ContainsSubstring("\nerror pressure ") &&
                                    !ContainsSubstring("\nerror neighbours ") &&
                                    ContainsSubstring("\n# error quantity rest worst until "));
  CHECK_THAT(succeeds({"review", golden, "--stated"}).out, ContainsSubstring("swinging |"));
  CHECK(launch({"check", scenario}).code == 0);
  accept(scenario);  // the same result: its error stays
  CHECK_THAT(readWhole(golden), ContainsSubstring("\nerror "));
  writeWhole(scenario, swings + "  precision: single\n");
  CHECK(intoGolden({scenario}).code == 3);  // the changed result is not accepted yet
  accept(scenario);
  CHECK_THAT(readWhole(golden), !ContainsSubstring("\nerror "));
}

TEST_CASE("review --into-golden takes a time, a budget and several scenarios, and leaves out what has no error") {
  const TemporaryFolder folder;
  const std::string scenario = folder / "swinging.yaml", lineage = folder / "lineage.yaml";
  writeWhole(scenario, swings);
  writeWhole(lineage, swings.substr(0, swings.find("physics:")));
  accept(scenario);
  const auto run =
      launch({"review", lineage, scenario, "--into-golden", "--until", "0.5", "--budget", "1e-9"}, {{"CI", ""}});
  CAPTURE(run.err);
  CHECK(run.code == 0);
  CHECK_THAT(run.err, ContainsSubstring("lineage.yaml: left out: it has no bodies"));
  CHECK_THAT(readWhole(folder / "swinging.golden"),
             ContainsSubstring(" 0.5 - - -\n") && ContainsSubstring("\nunstated mesh icosphere 2 takes about"));
  const auto told = intoGolden({scenario, "--json", "--until", "0.5"});
  CHECK(nlohmann::json::parse(told.out).at("file") == scenario);
  refuses(intoGolden({scenario, "--until", "2"}), 2, "--until: 2 is after the scene's end; needs at most 1");
  refuses(intoGolden({scenario, lineage, "--json"}), 2, "with --json review takes one scenario, not 2");
}

TEST_CASE("review --into-golden writes nothing in continuous integration") {
  const TemporaryFolder folder;
  writeWhole(folder / "swinging.yaml", swings);
  accept(folder / "swinging.yaml");
  const std::string before = readWhole(folder / "swinging.golden");
  CHECK(launch({"review", folder / "swinging.yaml", "--into-golden"}, {{"CI", "1"}}).code != 0);
  CHECK(readWhole(folder / "swinging.golden") == before);
}

TEST_CASE("review --stated prints golden/ERRORS.md of the shipped goldens") {
  CHECK_THAT(succeeds({"review", "golden/thesis/unique-four.golden", "--stated"}).out,
             ContainsSubstring("# The errors that goldens state\n") && ContainsSubstring("thesis/unique-four |"));
}
