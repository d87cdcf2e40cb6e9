// After a number of a scenario changed, check and explain reported hashes and ulps, never the key. Now changed keys
// with both values come first, then the lineage, then how far cells moved and how volumes and pressures changed. A
// changed key was one failure per check; now it is one, from which the others follow.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

const std::string comparedScene =
    "morula: 1\nname: pair\ndna: |\n  START: a0\n  g1(divide|a0)\ncycle: {length: 0.125}\nstop: {time: 0.25}\n"
    "physics:\n  mesh: {icosphere: 1}\n  cell: {radius: 0.95}\n  drag: 1\n  pressure: {constant: 155, outside: 43}\n  "
    "contact: {}\nrecord: {every: 0.125}\ncheck: {}\n";

/// Returns true if the text has the words in this order.
bool inOrder(const std::string& text, const Words& words) {
  std::size_t at = 0;
  for (const auto& word : words) {
    at = text.find(word, at);
    if (at == text.npos) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("what differs is told by key, lineage, movement, and only then by hash") {
  const TemporaryFolder folder;
  const std::string file = folder / "pair.yaml", db = folder / "run.db";
  writeWhole(file, comparedScene);
  accept(file);
  succeeds({"run", file, "--db", db, "--no-pictures", "--out", folder / "out"});
  CHECK_THAT(readWhole(folder / "pair.golden"), ContainsSubstring("\nparameter physics.pressure.constant 155\n"));

  writeWhole(file, replaced(comparedScene, "constant: 155", "constant: 155.5"));
  const Words words{"changed   physics.pressure.constant: 155 → 155.5\n",
                    "lineage   the same\n",
                    "moved     cell ",
                    " radii of the egg\n",
                    "volume    ",
                    " %\n",
                    "pressure  ",
                    " %\n"};
  const Words cause{"FAIL  scenario: INPUT_CHANGED, the scenario changed\n", "consequences: bits; step_hashes"};
  for (const char* verb : {"check", "explain", "review"}) {
    const auto run = endsWith(1, {verb, file});
    INFO(run.out);
    CHECK(inOrder(run.out, joined(words, cause)));
    CHECK(run.out.find("FAIL", run.out.find("FAIL") + 1) == run.out.npos);
    CHECK_THAT(run.out, !ContainsSubstring(" ulp"));
  }
  CHECK(inOrder(endsWith(1, {"explain", file, "--db", db}).out, words));
  const Json json = jsonOf({"explain", file}, 1);
  REQUIRE(json["changed"].size() == 1);
  CHECK(json["changed"][0] == Json{{"key", "physics.pressure.constant"}, {"expected", "155"}, {"actual", "155.5"}});
  CHECK(jsonOf({"check", file}, 1)["results"][0]["field"] == "physics.pressure.constant");

  writeWhole(file, replaced(comparedScene, "length: 0.125", "length: 0.0625"));
  const auto other = launch({"check", file});
  CHECK(inOrder(other.out, {"changed   cycle.length: 0.125 → 0.0625\n",
                            "lineage   the egg: divided at time 0.125 → divided at time 0.0625\n"}));
  launch({"review", file, "--reject", "--why", "only a test"});
}
