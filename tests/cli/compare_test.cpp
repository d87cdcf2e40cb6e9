// morula compare, as users start it.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "../unit/analysis/study_db.h"
#include "base/random.h"
#include "catch.h"
#include "launch.h"

using namespace morula;
using namespace morula::test;
using nlohmann::json;

namespace {

/// Writes a study whose clones are tighter under `longest`, where seeds change nothing, than under `random`.
void writePolicies(const std::string& file) {
  MadeStudy study;
  study.axes = {{"division", {"longest", "random"}}};
  study.seedless = [](const std::vector<int>& levels) { return levels[0] == 0; };
  study.values = [](const std::vector<int>& levels, int seed) {
    const double z = randomNormal({1, {}}, static_cast<std::uint32_t>(seed));
    return std::map<std::string, double>{{"clone_radius", levels[0] == 0 ? 1 : 1.047 + 0.005 * z}};
  };
  writeStudy(study, file);
}

}  // namespace

TEST_CASE("compare prints sentences, tables, JSON and CSV, and draws") {
  const TemporaryFolder folder;
  const std::string file = folder / "study.db";
  writePolicies(file);
  const auto text = succeeds({"compare", file});
  CHECK(text.err.empty());
  CHECK_THAT(text.out, ContainsSubstring("clone_radius: 4.6 % tighter under longest ("));
  CHECK_THAT(text.out, ContainsSubstring("), every one of 10 pairs: difference -0."));
  CHECK(launch({"study", "compare", file}).out == text.out);
  CHECK(launch({"study", "compare", "--help"}).out == launch({"compare", "--help"}).out);
  refuses({"study", "compare", file, "--csv", "--json"}, 2, "--csv and --json: give only one of them");
  CHECK(launch({"compare", folder.path()}).out == text.out);  // the database's folder
  CHECK(launch({"compare", file, "--by", "division"}).out == text.out);

  const json answer = jsonOf({"compare", file, "--equivalent", "5.1%"});
  const json& longest = answer.at("conditions").at(0);
  CHECK(longest.at("labels") == json{{"division", "longest"}});
  CHECK(longest.at("n") == 10);
  CHECK(longest.at("distinct") == 1);
  CHECK(longest.at("low").is_null());
  CHECK(answer.at("conditions").at(1).at("low") < answer.at("conditions").at(1).at("mean"));
  const json& pair = answer.at("pairs").at(0);
  CHECK(pair.at("a") == "longest");
  CHECK(pair.at("b") == "random");
  CHECK(pair.at("lower") == 10);
  CHECK(pair.at("high") < 0);
  CHECK(pair.at("effect") < -3);
  CHECK(pair.at("equivalence").at("verdict") == "equivalent");
  // A margin within which any two conditions would be equivalent.
  const json wide = jsonOf({"compare", file, "--equivalent", "10%"});
  CHECK(wide.at("pairs").at(0).at("equivalence").at("verdict") == "not tested");
  refuses({"compare", file, "--equivalent", "clone-radius=10%"}, 2, "is wider than the range of all its values");

  CHECK_THAT(launch({"compare", file, "--csv"}).out, ContainsSubstring("pair,clone_radius,,division,longest,random,"));
  for (const char* name : {"all.png", "all.svg", "all.pdf"}) {
    CHECK(launch({"compare", file, "-o", folder / name}).code == 0);
    CHECK(readWhole(folder / name).size() > 1000);
  }
}

TEST_CASE("compare --tidy prints one value a row, with the labels of all axes") {
  const TemporaryFolder folder;
  const std::string file = folder / "study.db";
  writePolicies(file);
  const auto runs = succeeds({"compare", file, "--tidy", "runs"});
  CHECK(runs.out.starts_with("division,seed,time,measure,value,unit\nlongest,1,"));
  const json answer = jsonOf({"compare", file});
  std::ptrdiff_t values = 0;
  for (const json& condition : answer.at("conditions")) values += condition.at("n").get<std::ptrdiff_t>();
  CHECK(std::ranges::count(runs.out, '\n') == 1 + values);
  CHECK(launch({"compare", file, "--tidy", "cells"})
            .out.starts_with("division,seed,time,cell,name,substances,measure,value,unit\n"));
}

TEST_CASE("A study is run, merged and compared, and its organisms are drawn") {
  const TemporaryFolder folder;
  writeWhole(folder / "pair.yaml",
             "morula: 1\nname: pair\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {time: 1.5}\n"
             "physics: {mesh: {icosphere: 1}, cell: {radius: 0.95}, drag: 5, shell: {sphere: 1}, contact: {}}\n"
             "variation: {share: 0.05}\n");
  writeWhole(folder / "pair.study.yaml",
             "morula-study: 1\nname: pair\nbase: pair.yaml\n"
             "vary: {drag: {little: {physics.drag: 4}, much: {physics.drag: 8}}}\n"
             "seeds: 1..4\nmeasures: {names: [sphericity, cells], when: {every: 0.5}}\nkeep: {pictures: first-seed}\n");
  const std::string study = folder / "pair.study.yaml", to = folder / "results";
  succeeds({"study", "run", study, "--out", to, "--quiet"});
  const json answer = jsonOf({"compare", to, "--pictures", folder / "all.png", "--moments", "3", "--quiet"});
  CHECK(readWhole(folder / "all.png").substr(1, 3) == "PNG");
  for (const Words& moments :
       {Words{"--moments", "1"}, {"--colour", "clone:1"}, {"--at-times", "0.5,1.25"}, {"--at-cells", "2,3"}}) {
    succeeds(joined({"compare", to, "--pictures", folder / "some.png", "--quiet"}, moments));
    CHECK(readWhole(folder / "some.png") != readWhole(folder / "all.png"));
  }
  // The pictures of the ends are those that the study keeps; here other pictures take their places.
  const std::string some = folder / "some.png";
  const auto drawn = [&](const std::string& colour) {
    succeeds({"compare", to, "--pictures", some, "--moments", "1", "--colour", colour, "--quiet"});
    return readWhole(some);
  };
  const std::string before = drawn("substance"), clones = drawn("clone");
  for (const auto& entry : std::filesystem::directory_iterator(to + "/pictures"))
    std::filesystem::copy_file(folder / "all.png", entry.path(), std::filesystem::copy_options::overwrite_existing);
  CHECK(drawn("substance") != before);
  CHECK(drawn("clone") == clones);
  std::filesystem::remove_all(to + "/pictures");
  CHECK(drawn("substance") != before);  // computed again; stored pictures have words
  CHECK(answer.at("conditions").size() == 4);
  CHECK(answer.at("conditions").at(0).at("n") == 4);
  CHECK(answer.at("conditions").at(0).at("distinct") == 4);
  CHECK(answer.at("courses").at(0).at("points").size() == 4);  // at times 0, 0.5, 1 and 1.5
  CHECK(answer.at("unfinished").empty());
}
