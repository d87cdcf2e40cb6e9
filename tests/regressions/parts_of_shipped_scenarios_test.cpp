// `parts` of a scenario whose cells have meshes of different fineness ended as a bug (exit code 70). It tells
// the parts of every shipped scenario that is valid.
#include <filesystem>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("parts of every shipped scenario") {
  namespace fs = std::filesystem;
  int told = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(MORULA_SOURCE_DIR) / "scenarios")) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string file = entry.path().string();
    if (launch({"validate", file}).code != 0) continue;
    const auto run = launch({"parts", file, "--json", "--rehearsal", "1e4", "--no-pictures"});
    CAPTURE(file, run.err);
    // What must fail as it runs may do so in the rehearsal.
    const bool mustFail = readWhole(file).find("\n  fails:") != std::string::npos;
    CHECK((run.code == 0 || (mustFail && run.code == 4)));
    ++told;
  }
  CHECK(told > 40);
}
