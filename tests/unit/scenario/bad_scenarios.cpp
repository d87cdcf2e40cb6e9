// Every file in tests/bad_scenarios is refused with exactly the messages that stand beside it.
#include <algorithm>

#include "helpers.h"

using namespace morula;
using namespace morula::test;

TEST_CASE("bad scenario files are refused with the expected messages") {
  namespace fs = std::filesystem;
  // Tests run in the source folder, so that messages name no folder of this machine.
  const fs::path folder = "tests/bad_scenarios";
  REQUIRE(fs::is_directory(folder));
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() >= 40);
  for (const auto& file : files) {
    INFO(file.string());
    CHECK(refusalOf([&] { loadScenario(file); }) + "\n" == readText(fs::path(file).replace_extension(".expected")));
  }
}

TEST_CASE("a file that cannot be read is no scenario mistake") {
  CHECK_THROWS_AS(loadScenario("no/such/file.yaml"), FileError);
  CHECK_THROWS_AS(loadScenario("tests"), FileError);
}
