// check --beside asks several engines at a time, and each worker wrote a line and its end apart: lines ran
// into each other. Each line is whole.
#include <sstream>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("beside: what several workers tell at a time stays in lines") {
  const TemporaryFolder folder;
  // Without bodies nobody can be asked, so that answers come as fast as they can be written.
  const std::string file = folder / "genes.yaml";
  writeWhole(file,
             "morula: 1\nname: genes\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {cycles: 1}\ncheck: {}\n");
  std::vector<std::string> arguments{"check", "--beside", "thesis,bullet,b3"};
  arguments.insert(arguments.end(), 300, file);
  const auto run = launch(arguments);
  std::istringstream lines(run.err);
  int told = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("cannot be asked") == line.npos && !line.empty()) continue;  // of the check itself
    CAPTURE(line);
    CHECK(line.ends_with(": cannot be asked: cells without bodies"));
    CHECK(line.find("cannot be asked") == line.rfind("cannot be asked"));
    ++told;
  }
  CHECK(told == 4 * 300);
}
