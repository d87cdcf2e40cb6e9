// The legend listed every colour of the scenario, even of substances that no cell in the picture holds. A picture must
// depend on a colour if and only if the picture shows it.
#include "catch.h"
#include "launch.h"

using namespace morula::test;

namespace {

std::string picture(const std::string& colours, const std::string& style) {
  const TemporaryFolder folder;
  writeWhole(folder / "s.yaml",
             "morula: 1\nname: s\ndna: |\n  START: a\n  g1(b|a)\n  g2(b|b)\n  g3(divide|a)\n  g4(c|b, c)\n"
             "cycle: {length: 0.125}\nstop: {cycles: 2}\nphysics:\n  mesh: {icosphere: 0}\n"
             "cells: [{at: [0, 0, 0]}, {at: [3, 0, 0], substances: [c]}]\n"
             "colours: " +
                 colours);
  succeeds({"render", folder / "s.yaml", "--size", "200", "--style", style, "-o", folder / "s.png"});
  return readWhole(folder / "s.png");
}

}  // namespace

TEST_CASE("a legend lists the colours in its picture and no others") {
  for (const std::string style : {"solid", "wireframe", "both", "lineage"}) {
    CAPTURE(style);
    // The substance c is gone after the first cycle; g4 needs a substance that no cell ever holds.
    const auto b = picture("{b: '#377eb8'}\n", style);
    CHECK(picture("{b: '#377eb8', c: '#e41a1c'}\n", style) == b);
    CHECK(picture("{b: '#377eb8', c*: '#e41a1c'}\n", style) == b);
    CHECK(picture("{b: '#377eb8', divide: '#e41a1c'}\n", style) !=
          picture("{b: '#377eb8'}\n", style == "lineage" ? style : "lineage"));
    CHECK(picture("{'b*': '#377eb8'}\n", style) != b);  // the legend shows its label
    CHECK(picture("{c: '#e41a1c'}\n", style) != b);
  }
}
