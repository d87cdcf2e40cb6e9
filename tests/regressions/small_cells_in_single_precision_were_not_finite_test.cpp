// Lists are padded with a vertex far away. Divided by the squared radius of small cells, its squared distance
// overflowed single precision, and zero times infinity is no number: forces of all cells smaller than a fifth were
// wrong.
#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("cells of any size touch in single precision") {
  for (const auto& [radius, contents] : {std::pair<std::string, std::string>{"0.1", "4.19e-3"}, {"0.001", "4.19e-9"}}) {
    const auto run = runText(
        "morula: 1\nname: small\ndna: |\n  START: a0\n  g1(a0|a0)\ncycle: {length: 100}\nstop: {time: 0.01}\n"
        "cells:\n  - {at: [-" +
        radius + ", 0, 0]}\n  - {at: [" + radius + ", 0, 0]}\nphysics:\n  precision: single\n  mesh: {icosphere: 2}\n" +
        "  cell: {radius: " + radius + "}\n  pressure: {constant: " + contents + ", outside: 1}\n  contact: {}\n");
    CAPTURE(radius, run.out, run.err);
    CHECK(run.code == 0);
  }
}
