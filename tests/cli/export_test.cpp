// morula export --ro-crate, checked against the requirements of RO-Crate 1.1 and the Process Run Crate profile 0.5.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "cli/crate.h"
#include "launch.h"
#include "store/store.h"
#include "stored.h"

using namespace morula::test;
namespace fs = std::filesystem;

namespace {

const std::string sceneOfTwoFiles = R"(morula: 1
name: small
dna: {file: two words.dna}
stop: {time: 1.5}
physics: {mesh: {icosphere: 1}, contact: {}}
record: {pictures: 1}
)";

/// A database with one run of the scene, and the run's pictures.
struct RunWithPictures {
  TemporaryFolder folder;
  std::string database = folder / "run.db", crate = folder / "crate", id;
  explicit RunWithPictures(const Words& more = {}, int code = 0) {
    writeWhole(folder / "small.yaml", sceneOfTwoFiles);
    writeWhole(folder / "two words.dna", "START: a0\ng1(divide|a0)\n");
    run(more, code);
    for (const char* picture : {"organism.png", "lineage.png"})
      if (fs::exists(folder / "small-0/" + picture))
        fs::copy_file(folder / "small-0/" + picture, folder / picture, fs::copy_options::overwrite_existing);
  }
  void run(const Words& more, int code = 0) {
    const Words words{"run", folder / "small.yaml", "--db", database, "--out", folder.path()};
    id = jsonOf(joined(words, more), code)["run_id"];
  }
  Json exported(const Words& more = {}) {
    succeeds(joined({"export", database, "--ro-crate", crate}, more));
    return Json::parse(readWhole(crate + "/ro-crate-metadata.json"));
  }
};

}  // namespace

TEST_CASE("a crate is what RO-Crate 1.1 and the profile require") {
  RunWithPictures stored;
  const Json crate = stored.exported({"--agent", "A. Nother", "--license", "https://spdx.org/licenses/CC0-1.0"});
  CHECK(mistakes(crate, stored.crate) == "");
  for (const char* part : {"run.db", "scenario/small.yaml", "scenario/resolved.json", "dna/two%20words.dna",
                           "pictures/organism.png", "pictures/lineage.png"}) {
    CAPTURE(part);
    CHECK(hasPart(crate, part));
  }
  CHECK(readWhole(stored.crate + "/scenario/small.yaml") == sceneOfTwoFiles);
  CHECK(readWhole(stored.crate + "/pictures/organism.png") == readWhole(stored.folder / "organism.png"));
  const Json& run = *find(crate, "#run");
  CHECK(run["identifier"] == stored.id);
  CHECK(run["actionStatus"] == "http://schema.org/CompletedActionStatus");
  CHECK(run["description"].get<std::string>().starts_with("morula run "));
  CHECK((*find(crate, "#agent"))["name"] == "A. Nother");
}

TEST_CASE("the validator of these tests sees what is wrong") {
  RunWithPictures stored({"--no-pictures"});
  const Json good = stored.exported();
  REQUIRE(mistakes(good, stored.crate) == "");
  const auto without = [&](const std::string& id, const std::string& property) {
    Json bad = good;
    for (Json& entity : bad["@graph"])
      if (entity["@id"] == id) entity.erase(property);
    return mistakes(bad, stored.crate);
  };
  for (const char* property : {"instrument", "endTime", "result", "actionStatus"}) {
    CAPTURE(property);
    CHECK(without("#run", property) != "");
  }
  CHECK(without("./", "datePublished") != "");
  CHECK(without("./", "hasPart") != "");
  CHECK(without("#morula", "softwareVersion") != "");
  Json dangling = good;
  dangling["@graph"].erase(dangling["@graph"].size() - 1);
  CHECK_THAT(mistakes(dangling, stored.crate), ContainsSubstring("a reference to nothing"));
  fs::remove(stored.crate + "/scenario/small.yaml");
  CHECK_THAT(mistakes(good, stored.crate), ContainsSubstring("no such file: scenario/small.yaml"));
}

TEST_CASE("the crate's database holds the exported run alone, and can be replayed") {
  RunWithPictures stored;
  const std::string first = stored.id;
  stored.run({"--seed", "7", "--no-pictures"});
  const Json crate = stored.exported({"--run", first});
  CHECK(mistakes(crate, stored.crate) == "");
  CHECK_FALSE(hasPart(crate, "pictures/organism.png"));  // the run of this picture is unknown
  const auto runs = morula::Store::openForReading(stored.crate + "/run.db").runs();
  REQUIRE(runs.size() == 1);
  CHECK(runs[0].id == first);
  CHECK(morula::Store::openForReading(stored.database).runs().size() == 2);
  CHECK(launch({"replay", stored.crate + "/run.db"}).code == 0);
}

TEST_CASE("a failed run's crate says so, and why") {
  RunWithPictures stored({"--set", "physics.membrane.production=40"}, 4);
  const Json crate = stored.exported();
  CHECK(mistakes(crate, stored.crate) == "");
  CHECK((*find(crate, "#run"))["actionStatus"] == "http://schema.org/FailedActionStatus");
  CHECK_THAT((*find(crate, "#run"))["error"].get<std::string>(), ContainsSubstring("step "));
}

TEST_CASE("without a folder the runs are listed") {
  RunWithPictures stored({"--no-pictures"});
  CHECK_THAT(succeeds({"export", stored.database}).out, ContainsSubstring(stored.id));
  const Json json = jsonOf({"export", stored.database});
  CHECK(json["runs"][0]["run_id"] == stored.id);
  CHECK(json["runs"][0]["status"] == "done");

  // Databases may hold tables of others, with any names.
  change(stored.database, "CREATE TABLE \"a\"\"b\" (\"x\"\"y\" TEXT)");
  CHECK_THAT(succeeds({"export", stored.database, "--list"}).out,
             ContainsSubstring("\n  a\"b ") && ContainsSubstring("which run it is"));
}
