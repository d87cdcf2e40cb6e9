// These scenarios were valid, and the organism silently did less than was meant: `dye`, `grw`, `grow` without
// physics.growth, `make: by-gene` without a gene that makes `connect`, `START: a` that nothing reads, and `g1(b|b)`.
// Now each is refused with its place. A name that may be intended gives a warning, a name that is used none.
#include <algorithm>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

namespace {

/// Runs validate on a scenario with these genes, each on a line, and this rest.
Launched validated(const std::string& genes, const std::string& rest = "") {
  const TemporaryFolder folder;
  std::string text = "morula: 1\nname: s\nstop: {cycles: 2}\n" + rest + "dna: |\n";
  for (std::size_t at = 0; at < genes.size();) {
    const auto end = std::min(genes.find('\n', at), genes.size());
    text += "  " + genes.substr(at, end - at) + "\n";
    at = end + 1;
  }
  writeWhole(folder / "s.yaml", text);
  return launch({"validate", folder / "s.yaml"});
}

void checkRefused(const std::string& genes, const std::string& rest, const std::string& message) {
  const auto run = validated(genes, rest);
  CAPTURE(genes, rest, run.err, message);
  CHECK(run.code == 3);
  CHECK(run.err.find(message) != std::string::npos);
}

void checkFine(const std::string& genes, const std::string& rest = "") {
  const auto run = validated(genes, rest);
  CAPTURE(genes, rest, run.err);
  CHECK(run.code == 0);
  CHECK(run.err.empty());
}

}  // namespace

TEST_CASE("a near miss of a substance that acts is refused, wherever nothing else uses it") {
  const std::string start = "START: a\ng1(a|a)\n";
  for (const auto& [slip, meant] : {std::pair{"dye", "die"},
                                    {"di", "die"},
                                    {"grw", "grow"},
                                    {"gorw", "grow"},
                                    {"divde", "divide"},
                                    {"dvid", "divide"},
                                    {"Divde", "divide"},
                                    {"shink", "shrink"},
                                    {"conect", "connect"},
                                    {"relaese", "release"}})
    checkRefused(start + "g2(" + slip + "|a)", "",
                 "s.yaml:7:6: dna: '" + std::string(slip) + "' does nothing; did you mean '" + meant + "'?");
  checkRefused("START: a, conect\ng1(a|a)", "", "s.yaml:5:13: dna: 'conect' does nothing; did you mean 'connect'?");
}

TEST_CASE("names that only look like those of substances that act are fine where something uses them") {
  checkFine("START: a1\ng1(a1|a1)\ng2(due|a1)\ng3(a1|due)");
  checkFine("START: a1\ng1(a1|a1)\ng2(grown|a1)\ng3(grown|grown)");
  checkFine("START: a1\ng1(a1|a1)\ng2(due|a1)", "colours: {due: '#e41a1c'}\n");
  checkFine("START: a1\ng1(a1|a1)\ng2(due|a1)", "colours: {d*: '#e41a1c'}\n");
  checkFine("START: a1\ng1(a1|a1)\ng2(due|a1)", "cycle: {per-substance: {due: 2}}\n");
  checkFine("START: a1\ng1(a1|a1)\ng2(end|a1)\ng3(b1|a1)\ng4(cross|a1)\ng5(strong|a1)");
}

TEST_CASE("what has become of a cell may be named after what acted, with a warning") {
  const auto run = validated("START: a\ng1(a|a)\ng2(divided|a)");
  CHECK(run.code == 0);
  CHECK(run.err.find("warning: ") == 0);
  CHECK(run.err.find("s.yaml:7:6: dna: 'divided' does nothing; did you mean 'divide'?") != std::string::npos);
}

TEST_CASE("growth needs physics.growth, and connecting needs connections by gene") {
  const std::string grows = "START: a\ng1(a|a)\ng2(grow|a)", connects = "START: a\ng1(a|a)\ng2(connect|a)";
  checkRefused(grows, "physics: {}\n", ":8:6: dna: 'grow' has no effect here: ");
  checkRefused("START: shrink, a\ng1(a|a)", "physics: {}\n", ":6:10: dna: 'shrink' has no effect here: ");
  checkFine(grows, "physics: {growth: {}}\n");
  checkFine(grows);  // DNA may ask for more than a lineage does
  checkRefused(connects, "physics: {contact: {}}\n", ":8:6: dna: 'connect' has no effect here: ");
  checkRefused(connects, "physics: {contact: {}}\nconnections: {}\n", "connections.make is at-division");
  checkFine(connects, "physics: {contact: {}}\nconnections: {make: by-gene}\n");
  checkFine("START: a\ng1(a|a)\ng2(look|grow, a)\ng3(grow|a)", "physics: {}\n");  // a gene reads it
}

TEST_CASE("connections by gene need a gene that wants them, and neighbours") {
  const std::string none = "START: a\ng1(a|a)";
  for (const std::string make : {"by-gene", "both"})
    checkRefused(none, "physics: {contact: {}}\nconnections: {make: " + make + "}\n",
                 ":5:21: connections.make: no gene produces 'connect'");
  checkRefused("START: a\ng1(a|a)\ng2(connect|a)", "physics: {}\nconnections: {make: by-gene}\n",
               ":5:21: connections.make: genes connect only cells that touch");
  checkFine("START: a, connect\ng1(a|a)", "physics: {contact: {}}\nconnections: {make: by-gene}\n");
  checkFine(none, "physics: {contact: {}}\nconnections: {make: at-division}\n");
}

TEST_CASE("a START substance that nothing reads is refused; cells without any gene get a warning") {
  checkRefused("START: a, b\ng1(b|b)", "", "s.yaml:5:10: dna: no gene reads 'a'");
  checkFine("START: a, b\ng1(b|b)", "colours: {a: '#e41a1c'}\n");
  checkFine("START: a, b\ng1(b|b)", "cycle: {per-substance: {a: 2}}\n");
  const auto run = validated("START: a");
  CHECK(run.code == 0);
  CHECK(run.err.find("warning: ") == 0);
  CHECK(run.err.find("s.yaml:5:10: dna: there is no gene that reads 'a'") != std::string::npos);
}

TEST_CASE("a gene whose input can never be present is refused, through any number of genes") {
  const std::string a = "START: a\ng0(a|a)\n";
  checkRefused(a + "g1(b|b)", "", "s.yaml:7:8: dna: only this gene produces 'b'");
  checkRefused(a + "g1(b|c)\ng2(c|b)", "", "s.yaml:7:8: dna: 'c' is never present, because its producer (g2)");
  checkFine(a + "g1(b|a, A)\ng2(divide|a)");
  checkFine(a + "g2(c|b)\ng1(b|a)");  // the order of genes does not matter
  // A cell may begin with substances that neither START nor a gene gives.
  checkFine(a + "g1(divide|b)", "physics: {}\ncells: [{at: [0, 0, 0], substances: [b]}]\n");
  checkFine(a + "g1(b|b)", "physics: {}\ncells: [{at: [0, 0, 0], substances: [b]}]\n");
  // One cause gives one message.
  const auto run = validated(a + "g1(b|b)\ng2(c|b)\ng3(d|c)");
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
}
