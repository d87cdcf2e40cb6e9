// morula replay repeats a stored run and reports differences.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"
#include "store/store.h"
#include "stored.h"

using namespace morula::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string checkedScene = R"(morula: 1
name: small
dna: |
  START: a0
  g1(divide|a0)
stop: {time: 1.5}
physics: {mesh: {icosphere: 1}, contact: {}}
check: {}
)";

/// A database with one run of the scene.
struct RunToReplay {
  TemporaryFolder folder;
  std::string database = folder / "run.db", id;
  explicit RunToReplay(const Words& more = {}, int code = 0) {
    writeWhole(folder / "small.yaml", checkedScene);
    const Words words{"run", folder / "small.yaml", "--db", database, "--out", folder.path(), "--no-pictures"};
    id = jsonOf(joined(words, more), code)["run_id"];
  }
  void execute(const std::string& sql) { change(database, sql); }
  /// Gives the run the ids that follow from its row, as a program of this build would have stored them.
  void fit() {
    const auto run = morula::Store::openForReading(database).find(id);
    const std::string ids = "'" + morula::runId(run.record) + "'";
    execute("UPDATE run SET build_id = '" + buildId(run.record.build) + "', run_id = " + ids);
    for (const char* table : {"run_document", "cell", "sample", "cell_sample", "contact", "division", "time_step",
                              "step_hash", "cell_hash"})
      execute(std::string("UPDATE ") + table + " SET run_id = " + ids);
  }
};

Json condition(const Json& json, const std::string& item) {
  for (const auto& c : json["conditions"])
    if (c["item"] == item) return c;
  return {};
}

}  // namespace

TEST_CASE("a run replayed by the same program gives the same bits under the same conditions") {
  const RunToReplay stored;
  const std::string before = readWhole(stored.database);
  for (const Words& how : {Words{stored.database},
                           {stored.database, "--run", stored.id},
                           {stored.id, "--db", stored.database},
                           {stored.id.substr(0, 6), "--db", stored.database}}) {
    const auto run = succeeds(joined({"replay"}, how));
    CHECK_THAT(run.out,
               ContainsSubstring("conditions      all 19 the same") && ContainsSubstring("hashes on the way the same"));
    CHECK(run.out.ends_with("\nthe same bits\n"));
  }
  CHECK((readWhole(stored.database) == before));  // nothing was written
}

TEST_CASE("on another instruction set and number of threads the bits are the same, and it is said") {
  const RunToReplay stored;
  const Json json = jsonOf({"replay", stored.database, "--isa", "scalar", "--threads", "2"});
  CHECK(json["same_bits"] == true);
  CHECK(json["state_hash"]["same"] == true);
  CHECK(json["step_hashes"]["then"] > 3);
  CHECK(json["step_hashes"]["first_difference"].is_null());
  CHECK(condition(json, "isa")["same"] == false);
  CHECK(condition(json, "isa")["now"] == "scalar");
  CHECK(condition(json, "threads")["then"] == "1");
  CHECK(condition(json, "threads")["now"] == "2");
  CHECK(condition(json, "binary_hash")["same"] == true);
}

TEST_CASE("by itself a replay computes as the run did") {
  const RunToReplay stored({"--isa", "scalar", "--threads", "3"});
  const Json json = jsonOf({"replay", stored.database});
  CHECK(condition(json, "isa")["now"] == "scalar");
  CHECK(condition(json, "threads")["now"] == "3");
}

TEST_CASE("each condition that is not as it was is named") {
  RunToReplay stored;
  stored.execute(
      "UPDATE run SET sources = 's', git_commit = 'c', compiler = 'GNU 1', flags = '-O9', target = 'Moon', "
      "libraries = 'SQLite 1.0', cpu = 'abacus', kernel = 'k', binary_hash = 'b', fp_environment = 'upward', "
      "cpu_features = 'beads', version = '0'");
  stored.fit();
  const auto run = succeeds({"replay", stored.database});  // the results have the same bits nevertheless
  for (const char* item : {"sources", "commit", "compiler", "flags", "target", "libraries", "processor", "kernel",
                           "binary hash", "floating point", "processor features", "version", "build id"}) {
    CAPTURE(item);
    CHECK_THAT(run.out, ContainsSubstring(std::string("\n  ") + item + " "));
  }
  CHECK_THAT(run.out, ContainsSubstring("then  abacus"));
}

TEST_CASE("other bits give exit 1, and the first step is named") {
  RunToReplay stored;
  SECTION("at the end") {
    stored.execute("UPDATE run SET state_hash = '00000000000000000000000000000000'");
    CHECK_THAT(endsWith(1, {"replay", stored.database}).out,
               ContainsSubstring("state           differs") && ContainsSubstring("NOT the same bits"));
  }
  SECTION("on the way") {
    stored.execute("UPDATE step_hash SET hash = '00000000000000000000000000000000' WHERE step = 128");
    CHECK_THAT(endsWith(1, {"replay", stored.database}).out, ContainsSubstring("differ first at step 128"));
  }
  SECTION("a hash is gone") {
    stored.execute("DELETE FROM step_hash WHERE step = 128");
    CHECK(launch({"replay", stored.database}).code == 1);
  }
}

TEST_CASE("a run that failed fails again in the same way") {
  const RunToReplay stored({"--set", "physics.membrane.production=40"}, 4);
  CHECK_THAT(jsonOf({"replay", stored.database})["state_hash"]["now"].get<std::string>(),
             ContainsSubstring("failed: step "));
}

TEST_CASE("a replayed run is stored where it is asked for") {
  const RunToReplay stored;
  const std::string out = stored.folder / "again.db";
  CHECK(launch({"replay", stored.database, "--db-out", out}).code == 0);
  CHECK(jsonOf({"replay", stored.id, "--db", out})["run_id"] == stored.id);
}

TEST_CASE("a file that is older than a measure is replayed without it, which is said") {
  RunToReplay stored;
  stored.execute("ALTER TABLE sample DROP COLUMN shell_fill");
  CHECK_THAT(succeeds({"replay", stored.database}).out,
             ContainsSubstring("not compared    sample: the file has no column for shell_fill"));
}

TEST_CASE("what cannot be replayed") {
  RunToReplay stored;
  CHECK(launch({"replay", stored.id, "--db", stored.database, "--run", stored.id}).code == 2);
  CHECK(launch({"replay", stored.database, "--isa", "abacus"}).code == 2);
  stored.execute("UPDATE run SET status = 'killed', state_hash = NULL");
  refuses({"replay", stored.database}, 2, "--resume");
}

TEST_CASE("a shell's mesh is stored with the run: replay needs no file") {
  const TemporaryFolder folder;
  const std::string mesh = folder / "egg.obj", scenario = folder / "small.yaml", database = folder / "run.db";
  writeWhole(mesh, "v 2 2 2\nv -2 -2 2\nv -2 2 -2\nv 2 -2 -2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  writeWhole(scenario, replaced(checkedScene, "contact", "shell: {mesh: egg.obj}, contact"));
  succeeds({"run", scenario, "--db", database, "--quiet", "--no-pictures"});
  fs::remove(mesh);
  fs::remove(scenario);
  CHECK(launch({"replay", database}).code == 0);
}
