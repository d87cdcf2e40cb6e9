// The list `experiments`: entries arrive, name their cells in one grammar, and are written so that they can be read.
#include "state/experiment.h"
#include "values/cell_words.h"
// Included last, because of CHECK:
#include "helpers.h"

using namespace morula;
using namespace morula::test;

namespace {

std::string experimenting(const std::string& entries) {
  return "morula: 1\nname: x\ndna: |\n  START: a0\n  g1(a1|a0)\n  g2(divide|a0)\n  g3(ABp|a1, B)\n  g4(ABp|ABp)\n"
         "stop: {cycles: 4}\nnames: {cells: {A: ABa, B: ABp, AA: ABal}}\n"
         "physics: {shell: {sphere: 2}, contact: {}}\nconnections: {}\nexperiments: " +
         entries + "\n";
}

const std::vector<std::string> goodEntries = {
    "[{kill: ABa, at: 1.5}]",
    "[{kill: cell ABp, at: 1.5}]",
    "[{kill: substance ABp, after-birth: 0.25}]",
    "[{kill: clone ABa, share: 0.5, at-cells: 4}]",
    "[{kill: [path AA, path B*, generation 3, a1], at: 2}]",
    "[{kill: all, at: 2}]",
    "[{gene-off: g2, at: 0}, {gene-on: g2, at: 1}]",
    "[{set: physics.contact.damping, to: 0, at: 1}]",
    "[{cycles: clone ABa, factor: 1.1, at: 0}]",
    "[{delay: all, by: 0.5, share: 0.2, at-cells: 2}]",
    "[{connect: [cell ABa, cell ABp], at: 1.5}, {release: [path A, path B], at: 1.75}]",
};

struct BadEntry {
  const char *entries, *text;
};
const std::vector<BadEntry> badEntries = {
    {"[]", "experiments: is empty"},
    {"{kill: ABa}", "experiments: is a map"},
    {"[kill]", "experiments[0]: is 'kill'"},
    {"[{at: 1}]", "experiments[0]: does not say what is done; needs one of kill, gene-off"},
    {"[{kil: ABa, at: 1}]", "experiments[0]: does not say what is done; did you mean kill?"},
    {"[{kill: ABa}]", "experiments[0]: does not say when; needs one of at: TIME"},
    {"[{kill: ABa, at: 1, at-cells: 2}]", "experiments[0].at-cells: stands beside at"},
    {"[{kill: ABa, gene-off: g2, at: 1}]", "stands beside kill; write two entries"},
    {"[{kill: ABa, at: -1}]", "experiments[0].at: "},
    {"[{kill: ABa, at: 5}]", "experiments[0].at: comes after the end of the run, 4"},
    {"[{kill: ABa, at: 1, to: 3}]", "experiments[0].to: unknown key"},
    {"[{kill: ABp, at: 1}]", "'ABp' is the name of a cell (path B) and a substance; write 'cell ABp'"},
    {"[{kill: cell ABq, at: 1}]", "no cell is called 'ABq'"},
    {"[{kill: a9, at: 1}]", "'a9' is neither a cell's name nor a substance"},
    {"[{kill: path AC, at: 1}]", "'AC' is no path"},
    {"[{kill: generation x, at: 1}]", "is no generation"},
    {"[{kill: clon ABa, at: 1}]", "did you mean clone ABa?"},
    {"[{kill: ABa, share: 2, at: 1}]", "experiments[0].share: "},
    {"[{gene-off: g9, at: 1}]", "the DNA has no gene 'g9'"},
    {"[{gene-off: g2, after-birth: 1}]", "needs at or at-cells"},
    {"[{set: physics.dragg, to: 1, at: 1}]", "did you mean physics.drag?"},
    {"[{set: physics.mesh.icosphere, to: 1, at: 1}]", "cannot change while a scene runs"},
    {"[{set: physics.growth.rate, to: 1, at: 1}]", "the scene has no physics.growth"},
    {"[{set: physics.drag, at: 1}]", "experiments[0].to: is missing"},
    {"[{cycles: all, factor: 0, at: 1}]", "experiments[0].factor: "},
    {"[{delay: all, at: 1}]", "experiments[0].by: is missing"},
    {"[{connect: cell ABa, at: 1}]", "is not a pair of cells"},
};

}  // namespace

TEST_CASE("Experiments are read, resolved by path, and read again as the same scene") {
  for (const std::string& entries : goodEntries) {
    CAPTURE(entries);
    const Scenario once = read(experimenting(entries)), again = read(once.resolved);
    CHECK(once.warnings.empty());
    CHECK_FALSE(once.scene.experiments.empty());
    CHECK(again.resolved == once.resolved);
    CHECK(again.meaning == once.meaning);
    CHECK(once.meaning != read(experimenting("[{kill: path BB, at: 3.5}]")).meaning);
  }
  const Scene scene = read(experimenting("[{kill: clone ABal, at: 2}]")).scene;
  CHECK(scene.experiments[0].of[0].kind == CellSelection::Kind::clone);
  CHECK(scene.experiments[0].of[0].path == CellPath::parse("AA"));
}

TEST_CASE("What is wrong in an experiment is told with its entry and the remedy") {
  for (const auto& [entries, text] : badEntries) {
    CAPTURE(entries);
    CHECK_THROWS_WITH(read(experimenting(entries)), ContainsSubstring(text));
  }
}
