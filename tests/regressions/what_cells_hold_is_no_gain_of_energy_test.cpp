// Adhesion depends on the substances of cells. When these changed, the energy of parting the cells was gone, which
// looked like a gain of energy from nothing: "not sane", exit 1.
#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("a cell that no longer holds what made it stick has gained no energy") {
  for (const std::string gene : {"", "  g2(a|a)\n"}) {
    const auto run =
        runText("morula: 1\nname: two\ndna: |\n  START: a\n  g1(b|b)\n" + gene +
                "cells: [{at: [-1, 0, 1]}, {at: [0, 2, 1], substances: [b]}]\nstop: {time: 1.5}\nphysics:\n"
                "  mesh: {icosphere: 1}\n  contact: {adhesion: {pairs: [{of: [a, b], strength: 1}]}}\n");
    CAPTURE(gene, run.out, run.err);
    CHECK(run.code == 0);
  }
}
