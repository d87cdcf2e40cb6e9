// If standard output is closed or its disk is full, the program ends with exit 6 and a sentence. No file that it opens
// takes the number of a closed stream, so nothing is printed into files.
#include <sys/wait.h>

#include <cstdlib>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("standard output that is closed or full is told") {
  const TemporaryFolder folder;
  writeWhole(folder / "small.yaml", "morula: 1\nname: a\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {cycles: 1}\n");
  const auto shell = [&](const std::string& words) {
    return WEXITSTATUS(std::system(("'" + programFile() + "' " + words).c_str()));
  };
  const auto err = " 2>'" + (folder / "err") + "'";
  for (const std::string stream : {">&-", ">/dev/full"}) {
    CAPTURE(stream);
    CHECK(shell("validate '" + (folder / "small.yaml") + "' " + stream + err) == 6);
    CHECK(readWhole(folder / "err").find("standard output cannot be written") != std::string::npos);
    const auto picture = folder / "a.png";
    CHECK(shell("render --quiet --style lineage -o '" + picture + "' '" + (folder / "small.yaml") + "' " + stream +
                err) == 6);
    CHECK(readWhole(picture).find(picture) == std::string::npos);
  }
  CHECK(shell("validate '" + (folder / "small.yaml") + "' >/dev/null 2>&- <&-") == 0);
}
