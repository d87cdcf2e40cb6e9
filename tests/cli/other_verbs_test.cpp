// The verbs check, review, validate, schema, init, render and lineage.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string withoutBodies = "morula: 1\nname: small\ndna: 'START: a0'\nstop: {cycles: 2}\n";

}  // namespace

TEST_CASE("validate tells all files' mistakes, and passes good ones") {
  const auto good = jsonOf({"validate", uniqueFour, "scenarios/thesis/elegans-1024.yaml"});
  CHECK(good["scenarios"][0]["valid"] == true);
  CHECK(good["scenarios"][0]["scenario"] == "unique-four");
  CHECK(good["scenarios"][1]["valid"] == true);
  const auto bad = jsonOf({"validate", "tests/bad_scenarios/octal.yaml", uniqueFour}, 3);
  CHECK(bad["scenarios"][0]["valid"] == false);
  CHECK(bad["scenarios"][0]["errors"].size() == 1);
  CHECK(bad["scenarios"][1]["valid"] == true);
}

TEST_CASE("validate --resolved leaves nothing to defaults") {
  const auto resolved = Json::parse(succeeds({"validate", uniqueFour, "--resolved", "--set", "physics.drag=0.25"}).out);
  CHECK(resolved["physics"]["drag"] == 0.25);
  CHECK(resolved["physics"]["integrator"] == "velocity-verlet");
}

TEST_CASE("schema is JSON, and its tables are the ones in the repository") {
  CHECK(Json::parse(launch({"schema"}).out)["properties"].contains("physics"));
  CHECK(launch({"schema", "--markdown"}).out == readWhole("scenarios/PARAMETERS.md"));
}

TEST_CASE("a full disk is no success") {
  CHECK(system((std::string(MORULA_PROGRAM) + " schema > /dev/full 2> /dev/null").c_str()) >> 8 == 6);
}

TEST_CASE("init writes a scenario that is right, and nothing over a file that is there") {
  const TemporaryFolder folder;
  const auto file = folder / "my first.yaml";
  CHECK(launch({"init", file}).code == 0);
  CHECK(jsonOf({"validate", file})["scenarios"][0]["scenario"] == "my-first");
  refuses({"init", file}, 6, "is there already");
  CHECK(launch({"init", file, "--force"}).code == 0);
  CHECK(launch({"init"}).out.find("name: my-organism") != std::string::npos);
}

TEST_CASE("the worm-sized DNA is what the documented command writes") {
  CHECK(succeeds({"init", "--dna", "full-tree", "--levels", "10"}).out ==
        readWhole("scenarios/thesis/elegans-1024.dna"));
}

TEST_CASE("lineage: the same tree from the scenario and from the database") {
  const TemporaryFolder folder;
  succeeds({"run", uniqueFour, "--db", folder / "four.db", "--no-pictures"});
  CHECK(succeeds({"lineage", uniqueFour}).out == launch({"lineage", folder / "four.db"}).out);
  const auto json = jsonOf({"lineage", uniqueFour});
  REQUIRE(json["cells"].size() == 7);
  CHECK(json["cells"][0]["path"] == "");
  CHECK(json["cells"][0]["parent"].is_null());
  CHECK(json["cells"][6]["path"] == "BB");
  CHECK(json["cells"][6]["parent"] == "B");
  CHECK(json["cells"][6]["state"] == "a7");
  CHECK(json["cells"][6]["fate"] == "alive");
  CHECK(jsonOf({"lineage", "scenarios/thesis/elegans-1024.yaml"})["cells"].size() == 2047);
}

TEST_CASE("lineage draws the tree as its file's ending says, from the scenario and from the database") {
  const TemporaryFolder folder;
  REQUIRE(launch({"run", uniqueFour, "--db", folder / "four.db", "--no-pictures"}).code == 0);
  const std::pair<std::string, std::string> endings[] = {{".png", "\x89PNG"}, {".SVG", "<?xml"}, {".pdf", "%PDF-"}};
  for (const auto& [ending, beginning] : endings) {
    const auto file = folder / "a" + ending, other = folder / "b" + ending;
    const auto json = jsonOf({"lineage", uniqueFour, "-o", file});
    CHECK(json["cells"].size() == 7);
    CHECK(json["pictures"][0] == file);
    CHECK(readWhole(file).starts_with(beginning));
    REQUIRE(launch({"lineage", folder / "four.db", "-o", other}).code == 0);
    CHECK(readWhole(other) == readWhole(file));
    // The file is a picture of Morula, which render may replace.
    CHECK(launch({"render", uniqueFour, "--style", "lineage", "-o", other}).code == 0);
    CHECK(readWhole(other) == readWhole(file));
  }
}

TEST_CASE("lineage --quiet that draws the tree does not print it, too") {
  const TemporaryFolder folder;
  CHECK(succeeds({"lineage", uniqueFour, "--quiet", "-o", folder / "tree.svg"}).out.empty());
  CHECK_THAT(readWhole(folder / "tree.svg"), ContainsSubstring("<svg"));
  CHECK_THAT(succeeds({"lineage", uniqueFour, "--quiet"}).out, ContainsSubstring("egg  divided"));
  CHECK(jsonOf({"lineage", uniqueFour, "--quiet", "-o", folder / "again.svg"})["pictures"].size() == 1);
}

TEST_CASE("a scene that settles is told that it is sampled at its events only") {
  const TemporaryFolder folder;
  const auto warningsOf = [&](const std::string& integrator, const std::string& every) {
    writeWhole(folder / "scene.yaml",
               "morula: 1\nname: settled\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 1.5}\n"
               "physics: {mesh: {icosphere: 0}, integrator: " +
                   integrator +
                   "}\n"
                   "record: {every: " +
                   every + "}\n");
    return jsonOf({"validate", folder / "scene.yaml"})["scenarios"][0]["warnings"];
  };
  const auto warnings = warningsOf("quasi-static", "0.25");
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0].get<std::string>(),
             ContainsSubstring("scene.yaml:8:17: record.every: 0.25 is shorter than every cell cycle"));
  CHECK(warningsOf("quasi-static", "1").empty());
  CHECK(warningsOf("velocity-verlet", "0.25").empty());
}

TEST_CASE("render draws a scenario and a stored run alike") {
  const TemporaryFolder folder;
  REQUIRE(launch({"run", uniqueFour, "--db", folder / "four.db", "--no-pictures"}).code == 0);
  const auto a = jsonOf({"render", uniqueFour, "--time", "1.5", "--size", "200", "-o", folder / "a.png"});
  CHECK(a["pictures"][0] == folder / "a.png");
  CHECK(a["time"] == 1.5);
  const auto b = succeeds({"render", folder / "four.db", "--time", "1.5", "--size", "200", "-o", folder / "b.png"});
  CHECK(b.out == folder / "b.png" + "\n");
  CHECK(readWhole(folder / "a.png") == readWhole(folder / "b.png"));
  CHECK(readWhole(folder / "a.png").substr(1, 3) == "PNG");
}

TEST_CASE("review accepts with a reason, and check then passes until something changes") {
  const TemporaryFolder folder;
  const auto scenario = folder / "small.yaml";
  writeWhole(scenario, withoutBodies);
  const auto missing = jsonOf({"check", scenario}, 1);
  CHECK(missing["results"][0]["passed"] == false);
  accept(scenario);
  CHECK(fs::exists(folder / "small.golden"));

  const auto json = jsonOf({"check", scenario});
  REQUIRE(!json["results"].empty());
  for (const auto& result : json["results"]) {
    CHECK(result["passed"] == true);
    for (const auto* member :
         {"scenario", "check", "kind", "class", "first_step", "cell", "field", "share_of_tolerance"})
      CHECK(result.contains(member));
  }
  CHECK(launch({"run", scenario, "--out", folder.path()}).code == 0);

  writeWhole(scenario, withoutBodies + "seed: 7\n");
  CHECK(launch({"check", scenario}).code == 1);
  CHECK_THAT(endsWith(1, {"run", scenario, "--out", folder.path()}).out, ContainsSubstring("FAIL"));
  CHECK(launch({"run", scenario, "--out", folder.path(), "--no-check"}).code == 0);
}

TEST_CASE("a golden with physics holds for any instruction set and number of threads, and sees a changed default") {
  const TemporaryFolder folder;
  const auto scenario = folder / "bodies.yaml";
  const std::string text =
      "morula: 1\nname: bodies\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 1.25}\n"
      "physics: {mesh: {icosphere: 1}, cell: {radius: 0.95}, shell: {sphere: 1}, contact: {}}\n"
      "record: {every: 0.25}\n";
  writeWhole(scenario, text);
  accept(scenario);
  CHECK(launch({"check", scenario}).code == 0);
  CHECK(launch({"check", scenario, "--isa", "scalar", "--threads", "2"}).code == 0);

  writeWhole(scenario, text + "division: {plane: {axis: [0, 1, 0]}}\n");
  const auto json = jsonOf({"check", scenario}, 1);
  bool named = false;
  for (const auto& result : json["results"])
    named = named || (result["passed"] == false && result["first_step"].is_number() &&
                      result["check"].get<std::string>().starts_with("values"));
  CHECK(named);
}

TEST_CASE("with CI set nobody accepts") {
  const TemporaryFolder folder;
  writeWhole(folder / "small.yaml", withoutBodies);
  endsWith(3, {"review", folder / "small.yaml", "--accept", "--by", "tests", "--why", "no"}, {{"CI", "true"}});
  CHECK(!fs::exists(folder / "small.golden"));
}
