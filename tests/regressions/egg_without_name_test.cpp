// Messages called the egg "cell ''". Now one function names cells for people: "the egg", or "cell AB".
#include <filesystem>
#include <fstream>
#include <string>

#include "base/cell_path.h"
#include "base/error.h"
#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("the egg has a name, and so has every cell") {
  CHECK(morula::cellName("") == "the egg");
  CHECK(morula::cellName("AB") == "cell AB");
  CHECK(std::string(morula::NumericalError("", 3, "volume −1", "lower it").what()) ==
        "step 3, the egg: volume −1; lower it");
  CHECK(std::string(morula::NumericalError("B", 3, "volume −1", "lower it").what()) ==
        "step 3, cell B: volume −1; lower it");
}

TEST_CASE("a failure of the egg names the egg") {
  const TemporaryFolder folder;
  const auto run =
      endsWith(4, {"run", "scenarios/hard/stiff-inside-out.yaml", "--out", folder.path(), "--no-pictures"});
  CAPTURE(run.err);
  CHECK(run.err.find(", the egg: ") != std::string::npos);
  CHECK(run.err.find("''") == std::string::npos);
}

// New messages must use this function.
TEST_CASE("no source puts a cell's path between quotes") {
  int files = 0;
  for (const auto* folder : {"core", "runner"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const auto ending = entry.path().extension();
      if (ending != ".cpp" && ending != ".h") continue;
      ++files;
      CAPTURE(entry.path().string());
      CHECK(readWhole(entry.path().string()).find("cell '\"") == std::string::npos);
    }
  CHECK(files > 200);
}
