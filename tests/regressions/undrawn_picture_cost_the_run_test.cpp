// A study with pictures lost a run under a limit of memory in which nothing can be drawn. Now the run is kept, and the
// message names memory.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "hostile.h"

using namespace morula::test;

TEST_CASE("a task that finds no memory for its picture keeps its run") {
  if (!memoryCanBeLimited) return;
  const TemporaryFolder folder;
  writeWhole(folder / "body.yaml", smallBody);
  writeWhole(folder / "few.study.yaml",
             "morula-study: 1\nname: few\nbase: body.yaml\nvary: {drag: {low: {}, high: {physics.drag: 12}}}\n"
             "seeds: 1..2\nmeasures: [sphericity]\nkeep: {pictures: first-seed}\nlimits: {memory-per-run: 260M}\n");
  const auto said = jsonOf({"study", "run", folder / "few.study.yaml", "--no-predict", "--out", folder / "out"});
  CHECK(said["failed"].empty());
  REQUIRE(said["undrawn"].size() == 2);
  for (const auto& task : said["undrawn"]) {
    CHECK_THAT(task["reason"].get<std::string>(), ContainsSubstring("memory limit: "));
    const std::string file = folder / "out/tasks/" + task["task_id"].get<std::string>();
    CHECK(std::filesystem::exists(file + ".db"));
    CHECK(std::filesystem::is_empty(folder / "out/pictures"));
  }
}
