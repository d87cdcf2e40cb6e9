// morula bench as its users and other programs read it. What it measures is not judged here.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

bool isOneOf(const Json& value, const std::vector<std::string>& words) {
  return value.is_string() && std::find(words.begin(), words.end(), value.get<std::string>()) != words.end();
}

Launched quickBench(const std::string& folder, std::vector<std::string> more) {
  std::vector<std::string> arguments{"bench", "--quick", "--cells", "8", "--vertices", "42", "--out", folder};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return launch(arguments);
}

}  // namespace

TEST_CASE("bench --json: rows, machine and picture as the contract says") {
  const TemporaryFolder folder;
  const auto run = quickBench(folder.path(), {"--json"});
  CAPTURE(run.err);
  REQUIRE(run.code == 0);
  CHECK_THAT(run.err, ContainsSubstring("bench: packing 8 cells"));
  const auto json = Json::parse(run.out);
  CHECK(json["morula"] == 1);
  CHECK(json["machine"]["cpu"].is_string());
  REQUIRE(json["machine"]["peak"].size() >= 2);
  for (const auto& peak : json["machine"]["peak"]) CHECK(peak["multiply_add_per_second"] > 0);
  REQUIRE(json["machine"]["bandwidth"].size() >= 4);
  for (const auto& memory : json["machine"]["bandwidth"]) CHECK(memory["bytes_per_second"] > 0);
  CHECK(json["thesis"].size() == 6);
  CHECK(readWhole(json["picture"]).substr(1, 3) == "PNG");

  bool bullet = json["remarks"].empty() == false;  // it says so when it is left out
  std::size_t steps = 0;
  REQUIRE(json["rows"].size() > 20);
  for (const auto& row : json["rows"]) {
    CAPTURE(row.dump());
    CHECK(isOneOf(row["scene"], {"packed", "packed-friction", "packed-single", "free"}));
    CHECK(isOneOf(row["engine"], {"morula", "bullet-b1", "bullet-b2", "scalar"}));
    CHECK(isOneOf(row["stage"], {"step", "internal", "contact", "rebuild", "integrate"}));
    CHECK(row["cells"] == 8);
    CHECK(row["vertices"] == 42);
    CHECK((row["isa"].is_null() || isOneOf(row["isa"], {"scalar", "narrow", "avx2", "avx512"})));
    CHECK(row["isa"].is_null() == (row["engine"] != "morula"));
    CHECK((row["threads"] == 1 || row["threads"] == 2));
    CHECK(row["precision"] == (row["scene"] == "packed-single" ? "single" : "double"));
    CHECK(row["ns_per_vertex_step"].is_number());
    CHECK((row["share_of_limit"].is_null() || row["share_of_limit"] > 0));
    steps += row["stage"] == "step";
    bullet = bullet || row["engine"] == "bullet-b1";
  }
  CHECK(steps >= 4);
  CHECK(bullet);
}

TEST_CASE("bench counts the same on every run, and packs only once") {
  const TemporaryFolder folder;
  std::vector<Json> counted;
  for (int turn = 0; turn < 2; ++turn) {
    const auto run = quickBench(folder.path(), {"--json", "--no-bullet", "--stage", "step"});
    REQUIRE(run.code == 0);
    CHECK((run.err.find("packing") != run.err.npos) == (turn == 0));
    const auto json = Json::parse(run.out);
    Json counters = Json::array();
    for (const auto& row : json["rows"])
      counters.push_back({row["scene"], row["isa"], row["pairs_per_vertex_step"], row["rebuilds_per_step"]});
    counted.push_back(counters);
  }
  CHECK(counted[0].size() >= 4);
  CHECK(counted[0] == counted[1]);
}

TEST_CASE("bench for people: a table on stdout, nothing else with --quiet") {
  const TemporaryFolder folder;
  const auto run = quickBench(folder.path(), {"--quiet", "--no-bullet", "--stage", "internal,contact"});
  CHECK(run.code == 0);
  CHECK(run.err.empty());
  CHECK_THAT(run.out, ContainsSubstring("packed scene, 8 cells of 42 vertices") &&
                          ContainsSubstring("internal, ordinary code") && ContainsSubstring("bench.png"));
  CHECK(run.out.find("bullet") == run.out.npos);
}

TEST_CASE("bench refuses what it cannot measure") {
  const std::pair<std::vector<std::string>, std::string> mistakes[] = {
      {{"--cells", "0"}, "--cells: 0 is out of range"},
      {{"--cells", "many"}, "--cells: 'many'"},
      {{"--vertices", "100"}, "needs 42, 162 or 642"},
      {{"--isa", "mmx"}, "--isa: instruction set \"mmx\" is not available"},
      {{"--stage", "rebiuld"},
       "--stage: 'rebiuld' is not known; needs step, internal, contact, rebuild or integrate; did you mean rebuild?"},
      {{"--threads", "0"}, "--threads: 0 is out of range"},
      {{"--quick", "--full"}, "give one of them"},
      {{"--fast"}, "'--fast' is not expected"},
  };
  for (const auto& mistake : mistakes) {
    std::vector<std::string> arguments{"bench"};
    arguments.insert(arguments.end(), mistake.first.begin(), mistake.first.end());
    refuses(arguments, 2, mistake.second);
  }
}

TEST_CASE("Bullet's worker is not for people, and tells a broken request") {
  CHECK(launch({"--help"}).out.find("engine-worker") == std::string::npos);
  CHECK(launch({"no-such-verb"}).err.find("engine-worker") == std::string::npos);
  const auto run = launch({"engine-worker"});  // nothing on its stdin
  CHECK(run.code == 3);
  CHECK_THAT(run.err, ContainsSubstring("question to another engine cannot be read"));
}
