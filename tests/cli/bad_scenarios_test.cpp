// The whole program keeps the promises of tests/bad_scenarios: exit 3, the message on stderr, nothing on stdout.
#include <algorithm>
#include <filesystem>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
namespace fs = std::filesystem;

TEST_CASE("every bad scenario gives exit 3 and its message") {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator("tests/bad_scenarios"))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() >= 40);
  for (const auto& file : files) {
    INFO(file);
    const auto run = launch({"run", file});
    CHECK(run.code == 3);
    CHECK(run.out.empty());
    CHECK(run.err == readWhole(fs::path(file).replace_extension(".expected").string()));
  }
}

TEST_CASE("bad DNA in a file of its own gives exit 3 and names its line") {
  const TemporaryFolder folder;
  const auto scenario = folder / "s.yaml";
  for (const auto& entry : fs::directory_iterator("tests/bad_dna")) {
    if (entry.path().extension() != ".dna") continue;
    INFO(entry.path().string());
    writeWhole(scenario,
               "morula: 1\nname: s\ndna: {file: '" + fs::absolute(entry.path()).string() + "'}\nstop: {cycles: 1}\n");
    const auto run = launch({"run", "--allow-outside", scenario});
    CHECK(run.code == 3);
    CHECK(run.out.empty());
    CHECK(run.err.find(entry.path().filename().string() + ":") != std::string::npos);
  }
}
