// With standard output closed, the next file that was opened took its number, and what was printed went into it. What
// cannot be printed is exit 6, and no file is touched.
#include <sys/wait.h>

#include <cstdlib>

#include "catch.h"
#include "hostile.h"

using namespace morula::test;

TEST_CASE("standard output that is closed or full is told") {
  const TemporaryFolder folder;
  writeWhole(folder / "small.yaml", smallScene);
  const auto shell = [&](const std::string& words) {
    return WEXITSTATUS(std::system(("'" + programFile() + "' " + words).c_str()));
  };
  const auto err = " 2>'" + (folder / "err") + "'";
  for (const std::string stream : {">&-", ">/dev/full"}) {
    CAPTURE(stream);
    CHECK(shell("validate '" + (folder / "small.yaml") + "' " + stream + err) == 6);
    CHECK(readWhole(folder / "err").find("standard output cannot be written") != std::string::npos);
    const auto picture = folder / "a.png";
    CHECK(shell("render --quiet --style lineage -o '" + picture + "' '" + (folder / "small.yaml") + "' " + stream + err) == 6);
    CHECK(readWhole(picture).find(picture) == std::string::npos);
  }
  CHECK(shell("validate '" + (folder / "small.yaml") + "' >/dev/null 2>&- <&-") == 0);
}
