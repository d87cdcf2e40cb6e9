// A measure is a row of one table, and is then everywhere: database, golden, JSON and documents.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "database/database.h"
#include "golden/facts.h"
#include "launch.h"

using namespace morula;
using namespace morula::test;
using nlohmann::json;

namespace {

const std::string pairOfBalls =
    "morula: 1\nname: pair\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 0.125}\n"
    "cells: [{at: [-0.9, 0, 0]}, {at: [0.9, 0, 0]}]\n"
    "physics: {mesh: {icosphere: 1}, drag: 50, shell: {sphere: 3}, contact: {}}\n";

template <class Of>
std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& m : sampledMeasures<Of>()) all.push_back(m.name);
  return all;
}

std::string last(const std::filesystem::path& file, const std::string& table, const std::string& column) {
  Database db(file, Database::Mode::existing, std::chrono::seconds(1));
  Statement s(db, "SELECT CAST(" + column + " AS REAL) FROM " + table + " LIMIT 1");
  REQUIRE(s.next());
  return s.isNull(0) ? "null" : json(s.real(0)).dump();
}

}  // namespace

TEST_CASE("Each measure that samples hold is in the database, in JSON, in goldens and in the list") {
  const TemporaryFolder folder;
  writeWhole(folder / "pair.yaml", pairOfBalls);
  const auto run =
      launch({"run", folder / "pair.yaml", "--no-pictures", "--json", "--db", folder / "pair.db"});
  INFO(run.err);
  REQUIRE(run.code == 0);
  const json sample = json::parse(run.out).at("sample");
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
    CHECK(json(sample.at(name).get<double>()).dump() ==
          last(folder / "pair.db", "sample ORDER BY time DESC", name));
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

TEST_CASE("schema --measures --markdown prints scenarios/MEASURES.md") {
  CHECK(launch({"schema", "--measures", "--markdown"}).out == readWhole("scenarios/MEASURES.md"));
}

TEST_CASE("displacement and contact_duration are rows of the database where a scenario asks for them") {
  const TemporaryFolder folder;
  const auto rows = [](const std::filesystem::path& file, const std::string& condition) {
    Database db(file, Database::Mode::existing, std::chrono::seconds(1));
    std::vector<double> all;
    for (Statement s(db, "SELECT value FROM measure WHERE " + condition + " ORDER BY time"); s.next();)
      all.push_back(s.real(0));
    return all;
  };
  const std::string record = "record: {every: 0.0625, measures: [contact_duration, displacement]}\n";
  writeWhole(folder / "pair.yaml", pairOfBalls + record);
  REQUIRE(
      launch({"run", folder / "pair.yaml", "--no-pictures", "--quiet", "--db", folder / "pair.db"}).code ==
      0);
  CHECK(rows(folder / "pair.db", "scope='pair' AND name='contact_duration' AND a='A' AND b='B'") ==
        std::vector<double>{0, 0.0625, 0.125});
  CHECK(rows(folder / "pair.db", "name='displacement'").empty());  // no division made them
  CHECK(launch({"replay", folder / "pair.db"}).code == 0);

  writeWhole(
      folder / "two.yaml",
      "morula: 1\nname: two\ndna: |\n  START: a0\n  g1(divide|a0)\n  g2(a1|a0)\ncycle: {length: 0.125}\n"
      "stop: {time: 0.375}\nphysics: {mesh: {icosphere: 1}, drag: 5, shell: {sphere: 1}, contact: {}}\n" +
          record);
  const auto two =
      launch({"run", folder / "two.yaml", "--no-pictures", "--quiet", "--db", folder / "two.db"});
  INFO(two.err);
  REQUIRE(two.code == 0);
  const auto ways = rows(folder / "two.db", "scope='cell' AND name='displacement' AND a='A'");
  REQUIRE(ways.size() >= 4);
  CHECK(ways.front() < ways.back());
  CHECK(launch({"replay", folder / "two.db"}).code == 0);
}
