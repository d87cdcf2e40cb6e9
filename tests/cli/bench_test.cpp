// morula bench, as users and other programs see it. The measured times are not judged.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

bool isOneOf(const Json& value, const Words& words) {
  return value.is_string() && std::find(words.begin(), words.end(), value.get<std::string>()) != words.end();
}

Launched quickBench(const TemporaryFolder& folder, const Words& more) {
  return succeeds(joined({"bench", "--quick", "--cells", "8", "--vertices", "42", "--out", folder.path()}, more));
}

}  // namespace

TEST_CASE("bench --json: rows, machine and picture as the contract says") {
  const TemporaryFolder folder;
  const auto run = quickBench(folder, {"--json"});
  CHECK_THAT(run.err, ContainsSubstring("bench: packing 8 cells"));
  const auto json = Json::parse(run.out);
  CHECK(json["morula"] == 1);
  CHECK(json["machine"]["cpu"].is_string());
  REQUIRE(json["machine"]["peak"].size() >= 2);
  for (const auto& peak : json["machine"]["peak"]) CHECK((peak["multiply_add_per_second"] > 0 && peak["instructions_per_second"] > 0));
  REQUIRE(json["machine"]["bandwidth"].size() >= 4);
  for (const auto& memory : json["machine"]["bandwidth"]) CHECK(memory["bytes_per_second"] > 0);
  CHECK(json["thesis"].size() == 6);
  CHECK(readWhole(json["picture"]).substr(1, 3) == "PNG");

  bool bullet = json["remarks"].empty() == false;  // a remark says that Bullet is left out
  std::size_t steps = 0;
  REQUIRE(json["rows"].size() > 20);
  for (const auto& row : json["rows"]) {
    CAPTURE(row.dump());
    CHECK(isOneOf(row["scene"], {"packed", "packed-still", "packed-viscosity", "packed-single", "free"}));
    CHECK(isOneOf(row["engine"], {"morula", "bullet-b1", "bullet-b2", "scalar"}));
    CHECK(isOneOf(row["stage"], {"step", "internal", "contact", "rebuild", "choice", "integrate"}));
    CHECK(row["cells"] == 8);
    CHECK(row["vertices"] == 42);
    CHECK((row["isa"].is_null() || isOneOf(row["isa"], {"scalar", "narrow", "avx2", "avx512"})));
    CHECK(row["isa"].is_null() == (row["engine"] != "morula"));
    CHECK((row["threads"] == 1 || row["threads"] == 2));
    CHECK(row["precision"] == (row["scene"] == "packed-single" ? "single" : "double"));
    CHECK(row["ns_per_vertex_step"].is_number());
    CHECK((row["share_of_limit"].is_null() || row["share_of_limit"] > 0));
    CHECK(row["limit"].is_null() == row["share_of_limit"].is_null());
    if (row["limit"].is_object()) CHECK(row["limit"].contains(row["limit"]["bound"]));
    if (row["limit"].is_object()) CHECK(row["limit"].size() == 5);
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
    const auto run = quickBench(folder, {"--json", "--no-bullet", "--stage", "step"});
    CHECK((run.err.find("packing") != run.err.npos) == (turn == 0));
    const auto json = Json::parse(run.out);
    Json counters = Json::array();
    for (const auto& row : json["rows"])
      counters.push_back({row["scene"], row["isa"], row["pairs_per_vertex_step"], row["rebuilds_per_step"],
                          row["slots_per_vertex_step"], row["choices_per_step"]});
    counted.push_back(counters);
  }
  CHECK(counted[0].size() >= 4);
  CHECK(counted[0] == counted[1]);
}

TEST_CASE("bench for people: a table on stdout, nothing else with --quiet") {
  const TemporaryFolder folder;
  const auto run = quickBench(folder, {"--quiet", "--no-bullet", "--stage", "internal,contact"});
  CHECK(run.err.empty());
  CHECK_THAT(run.out, ContainsSubstring("packed scene, 8 cells of 42 vertices") &&
                          ContainsSubstring("internal, ordinary code") && ContainsSubstring("bench.png"));
  CHECK(run.out.find("bullet") == run.out.npos);
}

TEST_CASE("Bullet's worker is not for people, and tells a broken request") {
  CHECK(launch({"--help"}).out.find("internal") == std::string::npos);
  CHECK(launch({"no-such-verb"}).err.find("internal") == std::string::npos);
  const auto run = launch({"internal", "engine-worker"});  // stdin is empty
  CHECK(run.code == 3);
  CHECK_THAT(run.err, ContainsSubstring("request to another engine cannot be read"));
}
