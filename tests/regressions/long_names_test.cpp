// Names of 10⁴ letters made a lineage picture take 18 s, because the label was measured again for each letter removed,
// and nothing limited names. Now names have at most 100 letters; messages give place and limit, and never repeat a name
// of a million letters. Labels take time by the letters that fit.
#include "catch.h"
#include "launch.h"

using namespace morula::test;

namespace {

const std::string million(1'000'000, 'a');

void checkRefused(const std::string& text, const std::string& place) {
  const TemporaryFolder folder;
  writeWhole(folder / "s.yaml", text);
  for (const std::string verb : {"validate", "run", "parts", "lineage", "render", "check"}) {
    const auto run = launch({verb, folder / "s.yaml"});
    CAPTURE(verb, place, run.err.substr(0, 500));
    CHECK(run.code == 3);
    CHECK(run.err.find("s.yaml:" + place) != std::string::npos);
    CHECK(run.err.size() < 2000);
  }
}

}  // namespace

TEST_CASE("names of a million letters are refused with their place and the limit") {
  const std::string head = "morula: 1\nname: s\nstop: {cycles: 2}\n";
  const std::string dna = "dna: |\n  START: a\n  g1(a|a)\n";
  checkRefused(head + "dna: |\n  START: " + million + "\n",
               "5:10: dna: a substance of 1000000 letters; a name has at most 100");
  checkRefused(head + "dna: |\n  START: a\n  g1(" + million + "|a)\n",
               "6:6: dna: the gene's product of 1000000 letters; a name has at most 100");
  checkRefused(head + "dna: |\n  START: a\n  " + million + "(a|a)\n", "6:3: dna: a");
  checkRefused("morula: 1\nname: " + million + "\nstop: {cycles: 2}\n" + dna, "2:7: name: ");
  // YAML itself reads no key of 1025 letters or more.
  const std::string thousand(1000, 'a');
  checkRefused(head + dna + thousand + ": 1\n", "7:1: a key of 1000 bytes; keys have at most 100");
  checkRefused(head + dna + "colours: {" + thousand + ": '#e41a1c'}\n", "7:11: colours: a key of 1000 bytes");
  checkRefused(head + dna + million + ": 1\n", "7:");
  checkRefused(head + dna + "colours: {" + million + ": '#e41a1c'}\n", "7:11: ");
  checkRefused(head + dna + "colours: {a: '" + million + "'}\n", "7:14: colours.a: ");
  checkRefused(head + dna + "physics: {integrator: " + million + "}\n", "7:23: physics.integrator: ");
}

TEST_CASE("names of a hundred letters are drawn") {
  const TemporaryFolder folder;
  const std::string name(100, 'a');
  writeWhole(folder / "s.yaml", "morula: 1\nname: s\nstop: {cycles: 4}\ndna: |\n  START: " + name + "\n  g1(" + name +
                                    "|" + name + ")\n  g2(divide|" + name + ")\ncolours: {" + name + ": '#e41a1c'}\n");
  succeeds({"render", folder / "s.yaml", "--style", "lineage", "-o", folder / "s.png"});
}
