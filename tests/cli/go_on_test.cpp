// morula run --resume of a run that has ended: it goes on to a later stop, or with a change, as the whole scene does.
#include <signal.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/isa.h"
#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;
using morula::Database;
using morula::Statement;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

// The stop of 2.2999 lies between two steps, so that the last step before it is shorter than the others.
const std::string scene = R"(morula: 1
name: goes-on
seed: 7
dna: |
  START: a0
  g1(a1|a0)
  g2(divide|a0)
  g3(divide|a1)
  g4(a2|a1)
  g5(divide|a2)
  g6(a3|a2)
physics:
  mesh: {icosphere: 2}
  drag: 2
  contact: {viscosity: 0.3}
connections: {}
record: {every: 0.25, meshes: 0.625}
)";
const std::string early = "stop: {time: 2.2999}\n", late = "stop: {time: 3}\n";

/// Returns the rows of a run in all tables of results, and of `run` the columns that the computation decides.
std::string rowsOf(const std::string& file, const std::string& id) {
  return rowsAsText(file, {"row_digest", "checkpoint", "document", "run_document"},
                    {"started", "ended", "command", "isa", "threads", "mother_run_id", "mother_time"}, id);
}

/// Runs a scenario in a folder, and tells its results.
struct Folder : TemporaryFolder {
  Json run(const std::string& what, const Words& more = {}) {
    return jsonOf(joined({"run", what, "--no-pictures", "--quiet", "--out", *this / "out"}, more));
  }
  std::string file(const std::string& name, const std::string& text) {
    writeWhole(*this / name, text);
    return *this / name;
  }
};

}  // namespace

TEST_CASE("stopped and then gone on to a later stop, a run has the hash and the rows of one run") {
  Folder folder;
  const std::string check = GENERATE("", "check: {}\n"), db = folder / "run.db";
  const Json first = folder.run(folder.file("early.yaml", scene + check + early), {"--db", db});
  const Json whole = folder.run(folder.file("late.yaml", scene + check + late), {"--db", folder / "whole.db"});
  const Json on = folder.run(db, {"--resume", "--set", "stop.time=3", "--threads", "2", "--isa", "scalar"});
  CHECK(on["resumed_at"].get<int>() > 100);
  CHECK(on["mother_run_id"] == first["run_id"]);
  CHECK(on["run_id"] == whole["run_id"]);
  CHECK(on["state_hash"] == whole["state_hash"]);
  const std::string rows = rowsOf(folder / "whole.db", whole["run_id"]);
  CHECK_THAT(rows, ContainsSubstring("== connection\n'") && ContainsSubstring("== mesh_sample\n'"));
  CHECK((rows.find("== step_hash\n'") != rows.npos) == !check.empty());
  CHECK(rowsOf(db, on["run_id"]) == rows);
  CHECK(integerIn(db, "SELECT count(*) FROM run") == 2);
  CHECK(integerIn(db, "SELECT count(*) FROM run WHERE mother_run_id = '" + first["run_id"].get<std::string>() +
                          "' AND mother_time = 2.2999") == 1);
  CHECK_THAT(succeeds({"replay", db}).out, ContainsSubstring("the same bits"));
  succeeds({"report", db, "-o", folder / "page.html", "--quiet"});
  CHECK_THAT(readWhole(folder / "page.html"), ContainsSubstring("Went on from run"));

  // The scenario file with a later stop goes on from the latest state that there is; here from the last run's.
  const Json again =
      folder.run(folder.file("early.yaml", scene + check + "stop: {cycles: 3, cells: 8}\n"), {"--db", db, "--resume"});
  CHECK(again["mother_run_id"] == on["run_id"]);
  CHECK(again["run_id"] != on["run_id"]);
  CHECK(again["state_hash"] == folder.run(folder / "early.yaml", {"--db", folder / "again.db"})["state_hash"]);
  const Json third = folder.run(db, {"--resume", "--run", again["run_id"], "--set", "stop={time: 3.1}"});
  CHECK(third["mother_run_id"] == again["run_id"]);
  CHECK(third["state_hash"] == folder.run(folder.file("third.yaml", scene + "stop: {time: 3.1}\n"))["state_hash"]);
}

TEST_CASE("gone on with a change, a run is that of the scenario with the experiment at that time") {
  Folder folder;
  const std::string db = folder / "run.db";
  const Json mother = folder.run(folder.file("early.yaml", scene + early), {"--db", db});
  std::vector<Words> ways{{"--isa", "scalar"}, {"--isa", "scalar", "--threads", "2"}, {"--isa", "narrow"}};
  if (morula::bestIsa() == morula::Isa::avx512)
    ways.insert(ways.end(), {{"--isa", "avx512"}, {"--isa", "avx512", "--threads", "2"}});
  else WARN("skipped: this processor has no AVX-512");
  const auto expected = [&](const std::string& experiments) {
    return folder.run(folder.file("changed.yaml", scene + late + "experiments: [" + experiments + "]\n"),
                      {"--db", folder / "changed.db"});
  };
  const auto goesOn = [&](const Words& changes, const std::string& experiments) {
    CAPTURE(experiments);
    const Json whole = expected(experiments);
    for (const Words& way : ways) {
      CAPTURE(way);
      const Json on =
          folder.run(db, joined(joined({"--resume", "--run", mother["run_id"], "--set", "stop.time=3"}, changes), way));
      CHECK(on["mother_run_id"] == mother["run_id"]);
      CHECK(on["run_id"] == whole["run_id"]);
      CHECK(on["state_hash"] == whole["state_hash"]);
      CHECK(on["experiments"] == whole["experiments"]);
      CHECK(rowsOf(db, on["run_id"]) == rowsOf(folder / "changed.db", whole["run_id"]));
    }
  };
  goesOn({"--set", "physics.drag=5"}, "{set: physics.drag, to: 5, at: 2.2999}");
  goesOn({"--set", "physics.drag=5", "--set", "physics.contact.damping=0.1"},
         "{set: physics.drag, to: 5, at: 2.2999}, {set: physics.contact.damping, to: 0.1, at: 2.2999}");
  for (const char* other : {"{kill: path AA, at: 2.2999}", "{gene-off: g5, at: 2.5}",
                            "{cycles: all, factor: 1.1, at: 2.2999}", "{delay: all, by: 0.3, share: 0.5, at: 2.2999}",
                            "{connect: [path AA, path BB], at: 2.2999}", "{release: [path AA, path AB], at: 2.6}"})
    goesOn({"--set", std::string("experiments=[") + other + "]"}, other);

  // A daughter goes on as well; what was changed first comes first.
  const Json daughter =
      folder.run(db, {"--resume", "--run", mother["run_id"], "--set", "physics.drag=5", "--set", "stop.time=2.6"});
  const Json second = folder.run(db, {"--resume", "--set", "physics.drag=1", "--set", "stop.time=3"});
  CHECK(second["mother_run_id"] == daughter["run_id"]);
  CHECK(second["state_hash"] ==
        expected("{set: physics.drag, to: 5, at: 2.2999}, {set: physics.drag, to: 1, at: 2.6}")["state_hash"]);
}

TEST_CASE("where a run cannot go on, it says why and begins anew with the same results") {
  Folder folder;
  const std::string db = folder / "run.db";
  const Json mother = folder.run(folder.file("early.yaml", scene + early), {"--db", db});
  const auto anew = [&](const std::string& text, const std::string& why, const Words& more = {}) {
    const auto run = succeeds(joined({"run", folder.file("early.yaml", text), "--db", db, "--resume", "--no-pictures",
                                      "--out", folder / "out", "--json"},
                                     more));
    CHECK_THAT(run.err, ContainsSubstring("nothing to resume: ") && ContainsSubstring(why) &&
                            ContainsSubstring("starting from the beginning"));
    CHECK(Json::parse(run.out)["mother_run_id"].is_null());
  };
  anew(scene + "stop: {time: 0.1}\n", "is not after time 2.29");
  anew(scene + "stop: {time: 2.3}\nexperiments: [{kill: path AA, at: 2.1}]\n",
       "experiments[0].kill is due, or may be, before time 2.29");
  anew(replaced(scene, "drag: 2", "drag: 3") + "stop: {time: 2.3}\n", "physics.drag: 2");
  // Who names a run wants to go on from that run, so the program does not begin anew.
  const auto no = [&](const std::string& set, const std::string& why) {
    refuses({"run", db, "--resume", "--run", mother["run_id"], "--no-pictures", "--set", "stop.time=2.4", "--set", set},
            2, why);
  };
  no("experiments=[{kill: path AA, at: 2}]",
     "cannot go on so: experiments[0].kill is due, or may be, before time 2.29");
  no("stop.when=[{cells: 3}]", "cannot go on so (stop.when");
  no("physics.mesh.icosphere=1", "--set physics.mesh.icosphere: physics.mesh.icosphere decides a run from its start");
  change(db, "DELETE FROM checkpoint");
  no("physics.drag=5", "keeps no state to go on from");
}

TEST_CASE("a run that was interrupted goes on with a change from where it was") {
  Folder folder;
  const std::string db = folder / "run.db", yaml = folder.file("long.yaml", scene + "stop: {time: 3.5}\n");
  const auto killed =
      launch({"run", yaml, "--db", db, "--no-pictures", "--checkpoint-every", "50"}, {}, [&](int process) {
        waitUntil([&] {
          try {
            return fs::exists(db) && integerIn(db, "SELECT count(*) FROM checkpoint") > 0;
          } catch (const std::exception&) { return false; }
        });
        kill(process, SIGKILL);
      });
  REQUIRE(killed.code == 128 + SIGKILL);
  const Json on = folder.run(db, {"--resume", "--set", "physics.drag=5"});
  const std::string at = Json(realIn(db, "SELECT time FROM experiment")).dump();
  CHECK(on["state_hash"] == folder.run(folder.file("changed.yaml", scene +
                                                                       "stop: {time: 3.5}\nexperiments: [{set: "
                                                                       "physics.drag, to: 5, at: " +
                                                                       at + "}]\n"))["state_hash"]);
}
