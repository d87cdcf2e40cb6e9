// A pipe or /dev/zero as scenario, DNA, mesh, database or golden was waited for or read for ever; /proc/self/mem ended as
// a bug, exit 70. Everything but a regular file of a sensible size is refused with a sentence.
#include <sys/stat.h>

#include <filesystem>

#include "catch.h"
#include "hostile.h"

using namespace morula::test;

namespace {

/// For reading, the file is an input of every verb that reads one.
std::vector<std::vector<std::string>> readers(const std::string& file, const std::string& scenario) {
  return {{"run", file},      {"parts", file},
          {"check", file},    {"explain", file},
          {"review", file},   {"validate", file},
          {"render", file},   {"lineage", file},
          {"accuracy", file}, {"export", file},
          {"replay", file},   {"replay", "ab", "--db", file},
          {"trail", file},    {"explain", "--db", file, scenario}};
}

}  // namespace

TEST_CASE("what is no regular file is refused by every verb that reads one") {
  const TemporaryFolder folder;
  writeWhole(folder / "small.yaml", smallScene);
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  std::filesystem::create_symlink("loop", folder / "loop");
  const auto refused = [](const std::vector<std::string>& words) {
    const auto run = launch(words);
    CAPTURE(words, run.err);
    CHECK((run.code == 6 || (words[0] == "replay" && run.code == 2)));
    CHECK(run.out.empty());
    CHECK(run.err.find("bug") == std::string::npos);
  };
  for (const auto& words : readers(folder / "pipe", folder / "small.yaml")) refused(words);
  for (const std::string& file : {std::string("/dev/zero"), std::string("/proc/self/mem"), folder.path(),
                                  folder / "loop", folder / std::string(300, 'x'), folder / "small.yaml/x"})
    for (const char* verb : {"validate", "export", "replay"}) refused({verb, file});
}

TEST_CASE("DNA, mesh, golden and results that are no regular files") {
  const TemporaryFolder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  writeWhole(folder / "dna.yaml", "morula: 1\nname: a\ndna: {file: pipe}\nstop: {cycles: 1}\n");
  writeWhole(folder / "mesh.yaml", smallBody);
  for (const std::string change : {"dna={file: pipe}", "physics.mesh={file: pipe}"}) {
    CAPTURE(change);
    const auto run = launch({"validate", "--set", change, folder / "mesh.yaml"});
    CAPTURE(run.err);
    CHECK(run.code == 3);
    CHECK(run.err.find("is a pipe") != std::string::npos);
  }
  CHECK(launch({"validate", folder / "dna.yaml"}).code == 3);
  writeWhole(folder / "small.yaml", smallScene);
  REQUIRE(mkfifo((folder / "small.golden").c_str(), 0600) == 0);
  for (const char* verb : {"check", "review"}) {
    const auto run = launch({verb, folder / "small.yaml"});
    CAPTURE(verb, run.err);
    CHECK(run.code == 6);
  }
  CHECK(launch({"run", "--no-check", "--no-pictures", "--db", folder / "pipe", folder / "small.yaml"}).code == 6);
  CHECK(launch({"run", "--no-check", "--no-pictures", "--db", "/dev/zero", folder / "small.yaml"}).code == 6);
  CHECK(launch({"run", "--no-check", "--out", folder / "small.yaml", folder / "small.yaml"}).code == 6);
}
