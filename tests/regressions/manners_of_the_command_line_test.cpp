// Small faults of the command line: requests were ignored, or refused with the wrong words or exit code.
#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("a chart of a time after the end is refused, as a picture is") {
  refuses({"chart", uniqueFour, "contacts", "--time", "1e9"}, 2, "--time: 1e+09 is after the end of the run");
}

TEST_CASE("what comes after the end of a scene that stops at a number of cells is not compared") {
  const TemporaryFolder folder;
  writeWhole(folder / "two.yaml",
             "morula: 1\nname: two\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cells: 2}\n"
             "physics: {mesh: {icosphere: 0}, drag: 10}\n");
  refuses({"accuracy", folder / "two.yaml", "--until", "3", "--quick", "--out", folder.path()}, 2,
          "--until: 3 is after the scene's end; needs at most 1");
}

TEST_CASE("what cannot be rejected is not said to be") {
  const TemporaryFolder folder;
  writeWhole(folder / "small.yaml", "morula: 1\nname: small\ndna: 'START: a0'\nstop: {cycles: 2}\n");
  refuses({"review", folder / "small.yaml", "--reject", "--why", "no"}, 6, "no result waits for a review");
}

TEST_CASE("a message does not repeat a word of a hundred kilobytes") {
  const std::string word(100'000, 'x');
  for (const Words& arguments : {Words{"validate", uniqueFour, "--set", word + "=1"},
                                 {"validate", uniqueFour, "--set", word},
                                 {"run", uniqueFour, "--isa", word},
                                 {"run", uniqueFour, "--" + word},
                                 {word}}) {
    const auto run = launch(arguments);
    CHECK((run.code == 2 || run.code == 3));
    CHECK(run.err.size() < 1000);
    CHECK(run.err.find("…") != std::string::npos);
  }
}
