// A speed near the largest number made an acceleration that is not a number. The hash of that state ended the run with
// exit code 70, before the next step would have found the error. Now such a run is refused or fails numerically.
#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("a scene whose forces are not finite at its start is refused") {
  const std::string scene =
      "morula: 1\nname: fast\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 0.5}\n"
      "cells:\n  - {at: [0, 0, 0], velocity: [1, 0, -1e308], stretch: [1.2, 1, 1]}\n"
      "physics:\n  mesh: {icosphere: 1}\n  cell: {radius: 1, mass: 1e6}\n  drag: 1e6\n"
      "  shell: {sphere: 2}\n";
  for (const std::string recorded : {"", "record: {every: 0.0625}\ncheck: {}\n"}) {
    const auto run = runText(scene + recorded, {"--quiet"});
    CAPTURE(recorded, run.out, run.err);
    CHECK(run.code == 3);  // nothing has run yet: the scene is wrong
  }
}
