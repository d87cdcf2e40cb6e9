// accuracy --target printed a command that exited with 4 at the second division: it had computed nothing beyond the
// horizon of chaos, and lighter daughters bear only shorter time steps. Now a printed command has been run to the end,
// and meets its error against a run with an eighth of its time steps.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

const std::string crowd =
    "morula: 1\nname: crowd\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\ncycle: {length: 0.25}\n"
    "stop: {time: 1}\nphysics:\n  mesh: {icosphere: 1}\n  drag: 10\n  shell: {sphere: 1}\n"
    "  cell: {radius: 0.95}\n  contact: {}\n";

/// Writes the crowd into the folder and returns the command that asks accuracy for settings.
Words asked(const TemporaryFolder& folder) {
  writeWhole(folder / "crowd.yaml", crowd);
  return {"accuracy", folder / "crowd.yaml", "--only", "--integrator", "velocity-verlet", "--rounds", "1",
          "--out",    folder.path(),         "--quiet"};
}

}  // namespace

TEST_CASE("accuracy --target: the printed command runs to its end, and holds its error") {
  const TemporaryFolder folder;
  const Words words = joined(asked(folder), {"--target", "3e-2", "--halvings", "2"});
  const Json json = jsonOf(words), target = json["target"];
  CHECK(json["times"].back() < 1);  // chaos: later times were not compared
  const Words command = target["run_to_the_end"]["command"];
  succeeds(joined(command, {"--no-check", "--no-pictures", "--quiet", "--out", folder.path()}));
  CHECK(target["run_to_the_end"]["error"] <= 3e-2);
  // Steps that were long enough only for fewer cells are not recommended, and accuracy says so.
  for (const Json& row : json["rows"])
    if (row["cpu_seconds"] < target["run_to_the_end"]["cpu_seconds"]) SUCCEED();

  CHECK_THAT(launch(words).out, ContainsSubstring("has been run to the end") &&
                                    ContainsSubstring("crowd: compared up to time ") &&
                                    ContainsSubstring(" of 1, at ") && ContainsSubstring("chaos follows"));
}

TEST_CASE("accuracy --target: a share of automatic time steps is what growing organisms are offered") {
  const TemporaryFolder folder;
  const Json json = Json::parse(launch(joined(asked(folder), {"--target", "1e-3", "--json"})).out);
  std::size_t shares = 0;
  for (const Json& row : json["rows"]) shares += row["settings"]["automatic_share"].is_number();
  CHECK(shares == 4);
  for (const Json& row : json["rows"]) {
    if (row["settings"]["automatic_share"] != 0.25) continue;
    Words words{"run", folder / "crowd.yaml", "--no-check", "--no-pictures", "--quiet", "--out", folder.path()};
    for (const auto& change : row["settings"]["set"]) words.insert(words.end(), {"--set", change});
    CHECK(launch(words).code == 0);
  }
}
