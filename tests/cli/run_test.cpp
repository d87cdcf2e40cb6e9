// morula run, end to end.
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A short scene: two cells, coarse meshes.
const std::string small = R"(morula: 1
name: small
summary: Two cells
dna: |
  START: a0
  g1(divide|a0)
stop: {time: 1.5}
physics: {mesh: {icosphere: 1}, contact: {}}
)";

}  // namespace

TEST_CASE("the README's first command: simulates, stores, checks, draws, and says where") {
  const TemporaryFolder folder;
  const auto run = succeeds({"run", uniqueFour, "--out", folder.path()});
  const auto results = folder / "unique-four-20080617/";
  for (const auto* file : {"run.db", "organism.png", "wireframe.png", "lineage.png", "sequence/0000.png"}) {
    INFO(file);
    CHECK(fs::file_size(results + file) > 1000);
  }
  CHECK(run.out.find(results + "run.db") != std::string::npos);
  CHECK(run.out.find(results + "organism.png") != std::string::npos);
  CHECK(run.out.find("4 cells") != std::string::npos);
  CHECK(run.out.find("all ") != std::string::npos);  // all checks pass
  CHECK(run.err.empty());
}

TEST_CASE("JSON: one object with the contract's members, and nothing else on stdout") {
  const TemporaryFolder folder;
  writeWhole(folder / "small.yaml", small);
  const auto json = jsonOf({"run", folder / "small.yaml", "--out", folder.path()});
  CHECK(json["morula"] == 1);
  CHECK(json["scenario"] == "small");
  CHECK(json["seed"] == 0);
  CHECK(json["status"] == "done");
  CHECK(json["cells"] == 2);
  CHECK(json["steps"] > 10);
  CHECK(json["run_id"].get<std::string>().size() == 16);
  CHECK(json["state_hash"].get<std::string>().size() == 32);
  CHECK(json["db"] == folder / "small-0/run.db");
  CHECK(json["pictures"].size() == 3);
  for (const auto& file : json["pictures"]) CHECK(fs::exists(file.get<std::string>()));
}

TEST_CASE("the same run has the same id and bits, however it is computed") {
  const TemporaryFolder folder;
  writeWhole(folder / "small.yaml", small);
  const auto run = [&](const Words& how) {
    const auto json = jsonOf(joined({"run", folder / "small.yaml", "--out", folder.path(), "--no-pictures"}, how));
    return json["run_id"].get<std::string>() + " " + json["state_hash"].get<std::string>();
  };
  const auto first = run({});
  CHECK(run({}) == first);
  CHECK(run({"--isa", "scalar"}) == first);
  CHECK(run({"--isa", "narrow"}) == first);
  for (const char* search : {"grid", "aabb-tree", "spatial-hash", "brute-force"})
    CHECK(run({"--search", search}) == first);
  CHECK(run({"--threads", "2"}) == first);
  CHECK(run({"--set", "physics.contact.viscosity=0.5"}) != first);
}

TEST_CASE("seeds: one run each, in folders of their own or in one database") {
  const TemporaryFolder folder;
  writeWhole(folder / "small.yaml", small);
  const auto json = jsonOf({"run", folder / "small.yaml", "--seeds", "1..3", "--set", "division.plane=random",
                            "--no-pictures", "--db", folder / "all.db"});
  REQUIRE(json["runs"].size() == 3);
  CHECK(json["runs"][0]["seed"] == 1);
  CHECK(json["runs"][2]["seed"] == 3);
  CHECK(json["runs"][0]["run_id"] != json["runs"][1]["run_id"]);
  CHECK(json["runs"][0]["state_hash"] != json["runs"][1]["state_hash"]);
  for (const auto& run : json["runs"]) CHECK(run["db"] == folder / "all.db");
}

TEST_CASE("a dry run writes nothing") {
  const TemporaryFolder folder;
  const auto json = jsonOf({"run", uniqueFour, "--dry-run", "--out", folder / "results", "--seeds", "1..2"});
  CHECK(json["runs"][1]["status"] == "planned");
  CHECK(json["runs"][1]["until"] == 6);
  CHECK(!fs::exists(folder / "results"));
  const auto run = succeeds({"run", uniqueFour, "--dry-run", "--out", folder / "results"});
  CHECK(run.out.find("would run until time 6") != std::string::npos);
  CHECK(!fs::exists(folder / "results"));
}

TEST_CASE("a numerical failure is stored and gives exit 4") {
  const TemporaryFolder folder;
  // Daughters with forty times their mother's membrane crumple at once.
  const auto run =
      endsWith(4, {"run", uniqueFour, "--out", folder.path(), "--set", "physics.membrane.production=40", "--json"});
  const auto json = Json::parse(run.out);
  CHECK(json["status"] == "failed");
  CHECK(json["state_hash"].is_null());
  CHECK(run.err.find("step ") != std::string::npos);
  CHECK(run.err.find("physics.") != std::string::npos);
  CHECK(fs::exists(json["db"].get<std::string>()));
}

TEST_CASE("Ctrl-C and kill end a run cleanly, stored as killed") {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}}) {
    const TemporaryFolder folder;
    const auto database = folder / "long.db";
    const auto run =
        launch({"run", uniqueFour, "--out", folder.path(), "--db", database, "--json", "--set", "stop.cycles=90000"},
               {}, [&, signal = signal](int process) {
                 waitUntilComputing(process);
                 kill(process, signal);
               });
    INFO(run.err);
    CHECK(run.code == code);
    CHECK(Json::parse(run.out)["status"] == "killed");
  }
}

TEST_CASE("quiet is quiet") {
  const Launched run = runText(small, {"--quiet"});
  CHECK(run.code == 0);
  CHECK(run.err.empty());
}

TEST_CASE("on a terminal errors are red, unless NO_COLOR says otherwise") {
  const auto red = launchOnTerminal({"rnu"}, {{"TERM", "xterm"}, {"NO_COLOR", ""}});
  if (!red) {
    WARN(skippedWithoutTerminal);
    return;
  }
  CHECK(red->code == 2);
  CHECK(red->err.find("\x1b[31m") != std::string::npos);
  const auto plain = launchOnTerminal({"rnu"}, {{"TERM", "xterm"}, {"NO_COLOR", "1"}});
  REQUIRE(plain);
  CHECK(plain->code == 2);
  CHECK(plain->err.find('\x1b') == std::string::npos);
  CHECK(launch({"rnu"}, {{"TERM", "xterm"}, {"NO_COLOR", ""}}).err.find('\x1b') == std::string::npos);
}

TEST_CASE("on a terminal a bar shows cells, time, speed and what is left, and goes away") {
  const TemporaryFolder folder;
  const auto run = launchOnTerminal(
      {"run", uniqueFour, "--out", folder.path(), "--no-pictures", "--set", "stop.cycles=60"}, {{"TERM", "xterm"}});
  if (!run) {
    WARN(skippedWithoutTerminal);
    return;
  }
  CHECK(run->code == 0);
  INFO(run->err);
  for (const auto* part : {"[=", " cells", "time ", " of 60", "steps/s", " left"})
    CHECK(run->err.find(part) != std::string::npos);
  CHECK(run->err.ends_with("\r\x1b[K"));
}
