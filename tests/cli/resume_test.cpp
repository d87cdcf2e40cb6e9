// morula run --resume: a run that is killed at any moment and resumed leaves the results of an undisturbed run.
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "database/store_error.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;
using morula::Database;
using morula::Statement;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A scene with contacts, connections, samples, hashes and pictures: rows in every table. It runs for some seconds.
const std::string sceneWithAll = R"(morula: 1
name: stopped
dna: |
  START: a0
  g1(a0|a0)
  g2(divide|a0)
stop: {time: 3.75}
physics:
  mesh: {icosphere: 3}
  cell: {radius: 0.95}
  drag: 2
  shell: {sphere: 1}
  contact: {viscosity: 0.3}
connections: {}
record: {every: 0.25, pictures: 1, meshes: 0.625}
check: {}
)";

/// Returns all rows of all tables, except when and how the run was made.
std::string contentOf(const std::string& file) {
  return rowsAsText(file, {"row_digest"},  // a digest covers when and how, too
                    {"started", "ended", "made", "command", "isa", "threads"});
}

/// Returns the last checkpoint's step; 0 while there is no row, no table or no file.
std::int64_t checkpointStep(const std::string& file) {
  if (!fs::exists(file)) return 0;
  try {
    return integerIn(file, "SELECT max(step) FROM checkpoint");
  } catch (const morula::StoreError&) { return 0; }
}

/// Sends the signal once the run computes.
Launched stopComputing(int signal, const Words& how) {
  return launch(how, {}, [&](int process) {
    waitUntilComputing(process);
    kill(process, signal);
  });
}

std::map<std::string, std::string> filesIn(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".png")
      files[fs::relative(entry.path(), folder).string()] = readWhole(entry.path().string());
  return files;
}

}  // namespace

TEST_CASE("killed three times and resumed, a run leaves the same database and the same pictures") {
  const TemporaryFolder folder;
  writeWhole(folder / "stopped.yaml", sceneWithAll);
  const std::string whole = folder / "whole/stopped-0", stopped = folder / "stopped/stopped-0";
  succeeds({"run", folder / "stopped.yaml", "--out", folder / "whole"});
  const Words resume{"run", folder / "stopped.yaml", "--out", folder / "stopped", "--resume"};
  std::int64_t step = 0;
  for (const Words& way : {Words{"--isa", "scalar"}, {"--threads", "2"}, {"--isa", "narrow"}}) {
    const auto run = launch(joined(joined(resume, {"--checkpoint-every", "50"}), way), {}, [&](int process) {
      waitUntil([&] { return checkpointStep(stopped + "/run.db") > step; });
      kill(process, SIGKILL);
    });
    INFO(run.err);
    CHECK(run.code == 128 + SIGKILL);
    CHECK(checkpointStep(stopped + "/run.db") > step);
    step = checkpointStep(stopped + "/run.db");
  }
  const auto end = succeeds(joined(resume, {"--json"}));
  CHECK(Json::parse(end.out)["resumed_at"] == step);
  CHECK_THAT(end.err, ContainsSubstring("stopped continues from step " + std::to_string(step)));
  const auto content = contentOf(whole + "/run.db");
  CHECK_THAT(content, ContainsSubstring("== contact\n'"));
  CHECK_THAT(content, ContainsSubstring("== connection\n'"));
  CHECK_THAT(content, ContainsSubstring("== step_hash\n'"));
  CHECK(contentOf(stopped + "/run.db") == content);
  CHECK(filesIn(whole).size() == 7);
  CHECK((filesIn(stopped) == filesIn(whole)));
}

TEST_CASE("Ctrl-C leaves a checkpoint without being asked, and the way on is told") {
  const TemporaryFolder folder;
  writeWhole(folder / "stopped.yaml", sceneWithAll);
  const auto database = folder / "run.db";
  const Words how{"run", folder / "stopped.yaml", "--db", database, "--no-pictures", "--out", folder.path()};
  const auto run = stopComputing(SIGINT, how);
  CHECK(run.code == 130);
  CHECK_THAT(run.out, ContainsSubstring("--resume"));
  CHECK(checkpointStep(database) > 0);
  const auto content = contentOf(database);
  CHECK_THAT(content, ContainsSubstring("'killed'"));

  const Words again = joined(how, {"--resume"});
  SECTION("to the end") {
    succeeds(again);
    auto other = how;
    std::replace(other.begin(), other.end(), database, folder / "whole.db");
    succeeds(other);
    CHECK(contentOf(database) == contentOf(folder / "whole.db"));
  }
  SECTION("forgotten, it is told, and nothing is lost") {
    const auto step = checkpointStep(database);
    const auto forgotten = stopComputing(SIGKILL, how);
    CHECK_THAT(forgotten.err, ContainsSubstring("--resume continues it"));
    CHECK(checkpointStep(database) == step);
    CHECK(launch(again).code == 0);
    CHECK_THAT(contentOf(database), ContainsSubstring("'done'"));
  }
  SECTION("recorded in another way it is refused, and nothing is lost") {
    change(database, "UPDATE checkpoint SET hash_every = NULL");
    refuses(again, 2,
            "samples every 0.25 and no state hashes, but this run has samples every 0.25 and state hashes every 64");
    CHECK(checkpointStep(database) > 0);
  }
  SECTION("a damaged checkpoint is refused") {
    change(database, "UPDATE checkpoint SET state = substr(state, 1, 1000)");
    CHECK_THAT(endsWith(6, again).err,
               ContainsSubstring("cannot be resumed: checkpoint: the checkpoint is cut short") &&
                   ContainsSubstring("leave out --resume"));
  }
  SECTION("another seed is another run, which says what differs") {
    CHECK_THAT(succeeds(joined(again, {"--seed", "5", "--set", "stop.time=0.1"})).err,
               ContainsSubstring("nothing to resume") && ContainsSubstring("seed: 0 then, 5 now") &&
                   ContainsSubstring("starting from the beginning"));
  }
}

TEST_CASE("with nothing to resume, a run says so and starts from the beginning") {
  const TemporaryFolder folder;
  const std::string scenario = "scenarios/thesis/elegans-128.yaml", database = folder / "run.db";
  const auto said = [&] {
    return succeeds({"run", scenario, "--db", database, "--no-pictures", "--set", "stop={cycles: 2}", "--out",
                     folder.path(), "--resume"})
        .err;
  };
  CHECK_THAT(said(), ContainsSubstring("nothing to resume: there is no unfinished run of elegans-128 in"));
  CHECK_THAT(said(), ContainsSubstring(" is finished; starting from the beginning"));
}
