// Two scenarios of one file name in different folders overwrote each other's results that wait for a review, and their
// JUnit suites had one name. Runs with --set shared a folder with the plain run. Now each has its own place.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::string sceneUntil(const std::string& time) {
  return "morula: 1\nname: twin\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: " + time + "}\ncheck: {}\n";
}

}  // namespace

TEST_CASE("scenarios of one file name keep their waiting results and their JUnit suites apart") {
  const TemporaryFolder folder;
  const std::string stem = fs::path(folder.path()).filename().string();  // a unique name
  Words files;
  for (const char* inside : {"a", "b"}) {
    fs::create_directory(folder / inside);
    files.push_back(folder / inside + "/" + stem + ".yaml");
    writeWhole(files.back(), sceneUntil("2"));
    accept(files.back());
    writeWhole(files.back(), sceneUntil("2.5"));
  }
  CHECK(launch({"check", files[0], files[1], "--reports", folder / "reports"}).code == 1);
  const auto waits = [&](std::size_t i) {
    const auto pending = fs::path(files[i]).parent_path() / ".pending";
    return fs::exists(pending) && occurrences(launch({"review", files[i]}).out, "waits    " + pending.string()) == 1;
  };
  CHECK((waits(0) && waits(1)));
  const std::string junit = readWhole(folder / "reports/junit.xml");
  for (const char* inside : {"/a/", "/b/"})
    CHECK(occurrences(junit, std::string("<testsuite name=\"") + folder.path() + inside + stem + "\"") == 1);
  CHECK(launch({"review", files[0], "--reject", "--why", "a test"}).code == 0);
  CHECK(waits(1));  // the other result still waits
  CHECK(launch({"review", files[1], "--reject", "--why", "a test"}).code == 0);
}

TEST_CASE("each variant of a scenario has a folder of its own, the plain one that of name and seed") {
  const TemporaryFolder folder;
  const std::string a = folder / "a.yaml", b = folder / "b.yaml";
  writeWhole(a, sceneUntil("2")), writeWhole(b, sceneUntil("3"));
  const auto dbOf = [&](const Words& more) {
    const Json json = jsonOf(joined({"run", "--no-pictures", "--out", folder / "out"}, more));
    Words databases;
    for (const auto& r : json.contains("runs") ? json["runs"] : Json{json}) databases.push_back(r["db"]);
    return databases;
  };
  Words all;
  for (const Words& more : {Words{a}, {a, "--seed", "7"}, {a, "--set", "stop.time=1"}, {a, "--set", "stop.time=1.5"}})
    all.push_back(dbOf(more)[0]);
  CHECK(all[0] == folder / "out/twin-0/run.db");
  CHECK(all[1] == folder / "out/twin-7/run.db");
  CHECK_THAT(all[2], Catch::Matchers::StartsWith(folder / "out/twin-0-"));
  CHECK(dbOf({a, "--set", "stop.time=1"})[0] == all[2]);  // the same variant, the same folder
  // Pictures lie in the variant's folder also if the database lies elsewhere.
  const auto dbElsewhere = [&](const std::string& file, const std::string& db) {
    const auto run = succeeds({"run", file, "--out", folder / "pictures", "--db", folder / db});
    return occurrences(run.out, folder / "pictures/twin-0/");
  };
  CHECK(dbElsewhere(a, "a.db") > 0);
  CHECK(dbElsewhere(b, "b.db") == 0);
  CHECK(dbElsewhere(a, "a.db") > 0);
  for (const auto& db : dbOf({a, b})) all.push_back(db);  // two files of one name at once
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}
