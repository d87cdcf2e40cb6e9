// morula study run, status, merge and emit, as users call them: exit codes, messages, and results after signals.
#include <dirent.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A study of twelve runs of about a tenth of a second.
struct Study {
  TemporaryFolder folder;
  Study() {
    writeWhole(folder / "small.yaml",
               replaced(readWhole(MORULA_SOURCE_DIR "/tests/studies/small.yaml"), "icosphere: 1", "icosphere: 2"));
    writeWhole(folder / "small.study.yaml",
               "morula-study: 1\nname: small\nbase: small.yaml\n"
               "vary: {division: {longest: {}, random: {division.plane: random}}}\nseeds: 1..6\nmeasures: "
               "[sphericity]\n");
  }
  /// Replaces the study by three runs that end and three endless ones.
  void makeEndless() const {
    writeWhole(folder / "small.yaml",
               "morula: 1\nname: some\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {cycles: 3}\n"
               "variation: {cycle: 0.01}\n");
    writeWhole(folder / "small.study.yaml",
               "morula-study: 1\nname: some\nbase: small.yaml\nvary: {length: {short: {}, endless: "
               "{stop.cycles: 1000000000}}}\nseeds: 1..3\nmeasures: [cells]\n");
  }
  Launched run(const Words& more, const std::function<void(int)>& meanwhile = {}) const {
    const Words words{"study", more.at(0), folder / "small.study.yaml", "--out", folder / "out"};
    return launch(joined(words, {more.begin() + 1, more.end()}), {}, meanwhile);
  }
  Words files(const std::string& ending) const {
    Words names;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "out"))
      if (entry.path().string().ends_with(ending)) names.push_back(entry.path().string());
    return names;
  }
  std::size_t results() const { return fs::exists(folder / "out/tasks") ? files(".db").size() : 0; }
};

Json parsed(const Launched& l) {
  INFO(l.err);
  return Json::parse(l.out);
}

/// Returns the child processes of `process`.
std::vector<int> childrenOf(int process) {
  std::ifstream list("/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children");
  std::vector<int> children;
  for (int child; list >> child;) children.push_back(child);
  return children;
}

/// Returns true if the process has not ended; a zombie has ended.
bool runs(int process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  return file >> number >> name >> state && state != "Z";
}

}  // namespace

TEST_CASE("a share, a task, the rest: each is computed once, and the whole is merged") {
  const Study s;
  CHECK(s.run({"status"}).code == 6);  // there is no plan yet
  const Launched third = s.run({"run", "--shard", "1/3", "--json", "--quiet"});
  REQUIRE(third.code == 0);
  const Json share = parsed(third);
  CHECK((share["asked"] == 4 && share["computed"] == 4 && !share.contains("merged")));
  const Launched before = s.run({"status", "--json"});
  CHECK(before.code == 5);
  const Json status = parsed(before);
  CHECK((status["done"] == 4 && status["missing"].size() == 8 && status["seconds_left"] > 0));
  const std::string id = status["missing"][0]["task_id"];
  CHECK(parsed(s.run({"run", "--task", id, "--json"}))["computed"] == 1);
  CHECK(s.run({"merge"}).code == 5);
  const Json rest = parsed(s.run({"run", "--jobs", "2", "--json"}));
  CHECK((rest["already"] == 5 && rest["computed"] == 7 && rest["merged"]["done"] == 12));
  const Launched after = s.run({"status"});
  CHECK(after.code == 0);
  CHECK_THAT(after.out, ContainsSubstring("12 runs: 12 done, 0 failed, 0 missing"));
  CHECK(s.run({"merge"}).code == 0);
  // Other verbs read the merged database too.
  const std::string run = launch({"export", s.folder / "out/study.db", "--list"}).out;
  CHECK_THAT(run, ContainsSubstring("result"));
  CHECK(launch({"replay", s.files("/study.db")[0]}).code == 0);
}

TEST_CASE("a study that was changed goes on with what is there, and is the same as if it had been run at once") {
  const Study study;
  const std::string file = study.folder / "small.study.yaml", first = readWhole(file);
  const auto with = [&](const std::string& old, const std::string& now) {
    writeWhole(file, replaced(readWhole(file), old, now));
  };
  with("seeds: 1..6", "seeds: 2..3");
  REQUIRE(study.run({"run", "--json", "--quiet"}).code == 0);
  with("seeds: 2..3", "seeds: 2..4");
  with("random: {division.plane: random}", "x: {division.plane: {axis: [1, 0, 0]}}, random: {division.plane: random}");
  refuses(study.run({"run", "--quiet"}), 6,
          "study run --update plans the study anew (4 of its 9 results exist and stay)");
  const auto updated = study.run({"run", "--update", "--json", "--quiet"});
  INFO(updated.err);
  REQUIRE(updated.code == 0);
  CHECK(parsed(updated).at("computed") == 5);
  CHECK(parsed(updated).at("already") == 4);
  CHECK(study.run({"run", "--quiet"}).code == 0);  // the new plan is in place
  const auto compare = [&](const std::string& folder) { return launch({"compare", study.folder / folder, "--json"}); };
  const auto grown = compare("out");
  REQUIRE(launch({"study", "run", file, "--quiet", "--out", study.folder / "at-once"}).code == 0);
  CHECK(grown.code == 0);
  CHECK(grown.out == compare("at-once").out);
}

TEST_CASE("a run that is ended from outside is no result") {
  const Study s;
  // The study has one endless run.
  writeWhole(s.folder / "small.yaml",
             "morula: 1\nname: endless\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {cycles: 1000000000}\n");
  writeWhole(s.folder / "small.study.yaml",
             "morula-study: 1\nname: endless\nbase: small.yaml\nseeds: [1]\nmeasures: [cells]\n");
  const Launched l = s.run({"run", "--no-predict"}, [&](int process) {
    waitUntil([&] { return !childrenOf(process).empty(); });
    for (const int child : childrenOf(process)) kill(child, SIGKILL);
  });
  INFO(l.out + l.err);
  CHECK(l.code == 5);
  CHECK_THAT(l.out, ContainsSubstring("stopped from outside by SIGKILL; the next study run repeats it"));
  CHECK(s.results() == 0);
  CHECK(s.run({"status"}).code == 5);
}

TEST_CASE("Ctrl-C ends a study in good order, and the same command goes on") {
  const Study s;
  s.makeEndless();
  std::set<int> children;
  const Launched l = s.run({"run", "--jobs", "2", "--no-predict"}, [&](int process) {
    waitUntil([&] { return s.results() == 3; });
    for (const int child : childrenOf(process)) children.insert(child);
    kill(process, SIGINT);
  });
  CHECK(l.code == 128 + SIGINT);
  CHECK_THAT(l.out, ContainsSubstring("were not begun; the same command continues the study"));
  for (const int child : children) CHECK_FALSE(runs(child));
  CHECK(s.files(".part").empty());
  CHECK(s.results() == 3);
  const Json rest = parsed(s.run({"run", "--json", "--dry-run"}));
  CHECK((rest["already"] == 3 && rest["asked"] == 6));
}

TEST_CASE("kill -9 leaves no process, and the next run removes what is left") {
  const Study s;
  s.makeEndless();
  std::vector<int> children;
  const Launched l = s.run({"run", "--jobs", "2", "--no-predict"}, [&](int process) {
    waitUntil([&] { return s.results() == 3; });
    children = childrenOf(process);
    kill(process, SIGKILL);
  });
  CHECK(l.code == 128 + SIGKILL);
  writeWhole(s.folder / "out/tasks/.morula-here-1-1.part", "half");  // a draft of a program killed while writing
  for (const int child : children) waitUntil([&] { return !runs(child); });
  CHECK(s.run({"run", "--shard", "1/6"}).code == 0);
  CHECK(s.files(".part").empty());
}

TEST_CASE("a dry run of a study writes nothing") {
  const Study s;
  const Launched l = s.run({"run", "--dry-run", "--no-predict"});
  CHECK(l.code == 0);
  CHECK_THAT(l.out, ContainsSubstring("would compute 12 runs into"));
  CHECK_FALSE(fs::exists(s.folder / "out"));
}

TEST_CASE("runs of a study that is predicted compute with as many threads as they are given") {
  const Study s;
  const Json told = parsed(s.run({"run", "--threads", "2", "--json"}));
  CHECK((told["computed"] == 12 && told["failed"].empty()));
}
