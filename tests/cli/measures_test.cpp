// A measure is a row of one table, and appears in database, golden, JSON and documents.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "golden/facts.h"
#include "launch.h"
#include "stored.h"

using namespace morula;
using namespace morula::test;
using nlohmann::json;

namespace {

const std::string pairOfBalls =
    "morula: 1\nname: pair\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 0.125}\n"
    "cells: [{at: [-0.9, 0, 0]}, {at: [0.9, 0, 0]}]\n"
    "physics: {mesh: {icosphere: 1}, drag: 50, shell: {sphere: 3}, contact: {}}\n";

template <class Of>
Words names() {
  Words all;
  for (const auto& m : sampledMeasures<Of>()) all.push_back(m.name);
  return all;
}

std::string last(const std::string& file, const std::string& table, const std::string& column) {
  Database db = opened(file);
  Statement s(db, "SELECT CAST(" + column + " AS REAL) FROM " + table + " LIMIT 1");
  REQUIRE(s.next());
  return s.isNull(0) ? "null" : json(s.real(0)).dump();
}

}  // namespace

TEST_CASE("Each measure that samples hold is in the database, in JSON, in goldens and in the list") {
  const TemporaryFolder folder;
  writeWhole(folder / "pair.yaml", pairOfBalls);
  const json sample = jsonOf({"run", folder / "pair.yaml", "--no-pictures", "--db", folder / "pair.db"}).at("sample");
  REQUIRE(sample.at("cell_sample").size() == 2);
  const json& cell = sample.at("cell_sample").at(0);
  const auto list = json::parse(launch({"schema", "--measures"}).out);
  const auto isListed = [&](const char* scope, const std::string& name) {
    return std::ranges::any_of(list.at(scope), [&](const json& row) { return row.at("name") == name; });
  };
  GoldenFacts facts;
  facts.mechanics = true;
  facts.describe = [](StateId) { return ""; };
  facts.cells.resize(1);
  const auto items = makeGoldenData(facts).items;
  const auto isInGolden = [&](const std::string& key) {
    return std::ranges::any_of(items, [&](const GoldenItem& i) { return idOf(i) == "value " + key; });
  };
  for (const std::string& name : names<Observation>()) {
    INFO(name);
    CHECK(json(sample.at(name).get<double>()).dump() == last(folder / "pair.db", "sample ORDER BY time DESC", name));
    CHECK(isListed("world", name));
    CHECK(isInGolden("final/organism/" + name));
  }
  for (const std::string& name : names<CellContext>()) {
    INFO(name);
    CHECK(json(cell.at(name).get<double>()).dump() ==
          last(folder / "pair.db", "cell_sample ORDER BY time DESC, path", name));
    CHECK(isListed("cell", name));
    CHECK(isInGolden("final/egg/" + name));
  }
  CHECK(cell.at("neighbours") == 1);
  for (const std::string& name : names<Touch>())
    CHECK(last(folder / "pair.db", "contact ORDER BY time DESC", name) != "null");
}

TEST_CASE("A measure of some cells alone may stand wherever one may: recorded, in charts, in colours and in studies") {
  const TemporaryFolder folder;
  const std::string scene =
      "morula: 1\nname: four\ndna: |\n  START: a0\n  g1(divide|a0)\n  g2(a0|a0)\n  g3(skin|a0)\ncycle: {length: "
      "0.125}\nstop: {cycles: 3}\n"
      "physics: {mesh: {icosphere: 1}, drag: 5, shell: {sphere: 1}, contact: {}}\n";
  const auto write = [&](const std::string& measures) {
    writeWhole(folder / "four.yaml", scene + "record: {every: 0.125, measures: [" + measures + "]}\n");
  };
  const auto wrong = [&](const std::string& measures) {
    write(measures);
    const auto answer = launch({"validate", folder / "four.yaml"});
    CHECK(answer.code == 3);
    return answer.err;
  };
  CHECK_THAT(wrong("shell_share of skni"), ContainsSubstring("record.measures: 'skni' is neither a cell's name nor a substance; "
                                                             "did you mean skin?"));
  CHECK_THAT(wrong("shell_shar of A"), ContainsSubstring("did you mean shell_share?"));
  CHECK_THAT(wrong("volume of A*"), ContainsSubstring("'volume of A*' is part of every sample already; remove it"));
  CHECK_THAT(wrong("age of A B"), ContainsSubstring("'A B' selects no cells; needs a path"));
  CHECK_THAT(wrong("lumen of A"), ContainsSubstring("'lumen' measures the whole organism and takes no 'of'"));
  CHECK_THAT(wrong("shell_share of A, shell-share of A"), ContainsSubstring("is given twice; remove it"));

  write("shell-share of A*, count of skin, generation, clone_spread of generation 1");
  const std::string db = folder / "four.db";
  succeeds({"run", folder / "four.yaml", "--no-pictures", "--quiet", "--db", db});
  const auto rows = [&](const std::string& condition) {
    return integerIn(db, "SELECT count(*) FROM measure WHERE time = (SELECT max(time) FROM sample) AND " + condition);
  };
  CHECK(rows("name = 'shell_share of A*' AND scope = 'cell' AND a LIKE 'A%'") == 4);
  CHECK(rows("name = 'shell_share of A*'") == 4);
  CHECK(rows("name = 'count of skin' AND scope = 'world' AND value = 8") == 1);
  CHECK(rows("name = 'clone_spread of generation 1' AND value > 1") == 1);
  CHECK(launch({"replay", db}).code == 0);

  for (const char* what : {"shell_share of A*", "generation of generation 3", "cell.volume of skin", "count of skin",
                           "count of BB*", "volume of AAA", "pair.area of A*"}) {
    INFO(what);
    CHECK(succeeds({"chart", db, what, "-o", folder / "chart.svg", "--quiet"}).err == "");
    CHECK_THAT(readWhole(folder / "chart.svg"), ContainsSubstring("<svg"));
  }
  const auto saysOf = [&](const char* what) { return launch({"chart", db, what, "-o", folder / "chart.svg"}).err; };
  CHECK_THAT(saysOf("shell_share of B*"), ContainsSubstring("--set 'record.measures=[shell_share of B*]'"));
  CHECK_THAT(saysOf("age of skn"),
             ContainsSubstring("'skn' is neither a cell's name nor a substance; did you mean skin?"));
  CHECK_THAT(saysOf("volumee of A"), ContainsSubstring("there is no measure 'volumee'; did you mean volume?"));
  CHECK(succeeds({"render", folder / "four.yaml", "--colour", "shell_share of A*", "-o", folder / "a.png", "--quiet"})
            .err == "");
  CHECK_THAT(launch({"render", folder / "four.yaml", "--colour", "shell_share of A B", "-o", folder / "a.png"}).err,
             ContainsSubstring("'A B' selects no cells"));
  CHECK_THAT(launch({"render", folder / "four.yaml", "--colour", "clone_radius", "-o", folder / "a.png"}).err,
             ContainsSubstring("is no colouring of cells"));
  CHECK(launch({"lineage", db, "--colour", "volume of A*", "-o", folder / "tree.svg", "--quiet"}).code == 0);
}

TEST_CASE("schema --measures --markdown prints scenarios/MEASURES.md") {
  CHECK(launch({"schema", "--measures", "--markdown"}).out == readWhole("scenarios/MEASURES.md"));
}

TEST_CASE("displacement and contact_duration are rows of the database where a scenario asks for them") {
  const TemporaryFolder folder;
  const auto rows = [](const std::string& file, const std::string& condition) {
    Database db = opened(file);
    std::vector<double> all;
    for (Statement s(db, "SELECT value FROM measure WHERE " + condition + " ORDER BY time"); s.next();)
      all.push_back(s.real(0));
    return all;
  };
  const std::string record = "record: {every: 0.0625, measures: [contact_duration, displacement]}\n";
  writeWhole(folder / "pair.yaml", pairOfBalls + record);
  succeeds({"run", folder / "pair.yaml", "--no-pictures", "--quiet", "--db", folder / "pair.db"});
  CHECK(rows(folder / "pair.db", "scope='pair' AND name='contact_duration' AND a='A' AND b='B'") ==
        std::vector<double>{0, 0.0625, 0.125});
  CHECK(rows(folder / "pair.db", "name='displacement'").empty());  // no division, so no displacement
  CHECK(launch({"replay", folder / "pair.db"}).code == 0);

  writeWhole(folder / "two.yaml",
             "morula: 1\nname: two\ndna: |\n  START: a0\n  g1(divide|a0)\n  g2(a1|a0)\ncycle: {length: 0.125}\n"
             "stop: {time: 0.375}\nphysics: {mesh: {icosphere: 1}, drag: 5, shell: {sphere: 1}, contact: {}}\n" +
                 record);
  succeeds({"run", folder / "two.yaml", "--no-pictures", "--quiet", "--db", folder / "two.db"});
  const auto ways = rows(folder / "two.db", "scope='cell' AND name='displacement' AND a='A'");
  REQUIRE(ways.size() >= 4);
  CHECK(ways.front() < ways.back());
  CHECK(launch({"replay", folder / "two.db"}).code == 0);
}
