// `dna: {file: /etc/shadow}` read any file that the user can read, and echoed its lines in messages. So did a mesh, and
// a scenario stored in a database. Now scenarios read only their own folder, unless --allow-outside is given.
#include <filesystem>

#include "catch.h"
#include "hostile.h"
#include "stored.h"

using namespace morula::test;

namespace {

constexpr const char* secret = "hunter2 is no gene\n";

std::string withDna(const std::string& file) {
  return "morula: 1\nname: a\ndna: {file: '" + file + "'}\nstop: {cycles: 1}\n";
}

}  // namespace

TEST_CASE("a scenario names files of its own folder only") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "in/below");
  writeWhole(folder / "secret", secret);
  writeWhole(folder / "in/below/a.dna", "START: a0\ng1(a1|a0)\n");
  std::filesystem::create_symlink("../secret", folder / "in/link");
  const auto scenario = folder / "in/a.yaml";
  const auto refusedBy = [&](const Words& verb, const std::string& file) {
    CAPTURE(file, verb);
    writeWhole(scenario, withDna(file));
    CHECK_THAT(endsWith(3, joined(verb, {scenario})).err, ContainsSubstring("' lies outside") &&
                                                              ContainsSubstring("--allow-outside") &&
                                                              !ContainsSubstring("hunter2"));
    CHECK_THAT(endsWith(3, joined(verb, {"--allow-outside", scenario})).err, ContainsSubstring("hunter2"));
  };
  const auto refused = [&](const std::string& verb, const std::string& file) { refusedBy({verb}, file); };
  for (const char* file : {"../secret", "link", "below/../../secret"}) refused("validate", file);
  for (const char* verb : {"validate", "run", "parts", "check", "render", "lineage", "explain", "review", "accuracy"})
    refused(verb, folder / "secret");
  refusedBy({"internal", "trail"}, folder / "secret");
  writeWhole(scenario, withDna("below/a.dna"));
  CHECK(launch({"validate", scenario}).code == 0);
  writeWhole(scenario, smallBody);
  CHECK_THAT(endsWith(3, {"validate", "--set", "physics.mesh={file: ../secret}", scenario}).err,
             !ContainsSubstring("hunter2"));
}

TEST_CASE("scenarios below one folder `scenarios` share their files") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "scenarios/a");
  std::filesystem::create_directories(folder / "scenarios/b");
  writeWhole(folder / "scenarios/b/x.dna", "START: a0\ng1(a1|a0)\n");
  writeWhole(folder / "scenarios/a/a.yaml", withDna("../b/x.dna"));
  CHECK(launch({"validate", folder / "scenarios/a/a.yaml"}).code == 0);
}

TEST_CASE("a scenario of a database reads no files") {
  const TemporaryFolder folder;
  const auto database = folder / "run.db";
  writeWhole(folder / "small.yaml", smallScene);
  writeWhole(folder / "secret", secret);
  succeeds({"run", "--quiet", "--no-check", "--no-pictures", "--db", database, folder / "small.yaml"});
  change(database,
         "UPDATE document SET content = ? WHERE hash IN (SELECT hash FROM run_document WHERE role = 'resolved')",
         morula::Blob{withDna(folder / "secret")});
  for (const Words& words : {Words{"replay", database}, {"render", "--style", "lineage", database}}) {
    const auto run = launch(words);
    CAPTURE(words[0], run.err);
    CHECK(run.code != 0);
    CHECK(run.code != 70);
    CHECK((run.out + run.err).find("hunter2") == std::string::npos);
  }
}
