// `dna: {file: /etc/shadow}` read any file that the user can read, and echoed its lines in messages; so did a mesh, and a
// scenario stored in a database. A scenario reaches its own folder only, unless --allow-outside is given.
#include <filesystem>

#include "catch.h"
#include "database/database.h"
#include "hostile.h"

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
  const auto refused = [&](const std::string& verb, const std::string& file) {
    CAPTURE(file, verb);
    writeWhole(scenario, withDna(file));
    const auto run = launch({verb, scenario});
    CHECK(run.code == 3);
    CHECK(run.err.find("hunter2") == run.err.npos);
    CHECK(run.err.find("' lies outside") != run.err.npos);
    CHECK(run.err.find("--allow-outside") != run.err.npos);
    const auto allowed = launch({verb, "--allow-outside", scenario});
    CHECK(allowed.code == 3);
    CHECK(allowed.err.find("hunter2") != allowed.err.npos);
  };
  for (const char* file : {"../secret", "link", "below/../../secret"}) refused("validate", file);
  for (const char* verb :
       {"validate", "run", "parts", "check", "render", "lineage", "explain", "trail", "review", "accuracy"})
    refused(verb, folder / "secret");
  writeWhole(scenario, withDna("below/a.dna"));
  CHECK(launch({"validate", scenario}).code == 0);
  writeWhole(scenario, smallBody);
  const auto mesh = launch({"validate", "--set", "physics.mesh={file: ../secret}", scenario});
  CHECK(mesh.code == 3);
  CHECK(mesh.err.find("hunter2") == mesh.err.npos);
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
  REQUIRE(launch({"run", "--quiet", "--no-check", "--no-pictures", "--db", database, folder / "small.yaml"}).code == 0);
  {
    morula::Database db(database, morula::Database::Mode::existing, std::chrono::seconds(1));
    morula::Statement(
        db, "UPDATE document SET content = ? WHERE hash IN (SELECT hash FROM run_document WHERE role = 'resolved')")
        .run(morula::Blob{withDna(folder / "secret")});
  }
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"replay", database}, {"render", "--style", "lineage", database}}) {
    const auto run = launch(words);
    CAPTURE(words[0], run.err);
    CHECK(run.code != 0);
    CHECK(run.code != 70);
    CHECK((run.out + run.err).find("hunter2") == std::string::npos);
  }
}
