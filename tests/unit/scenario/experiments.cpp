// The list `experiments`: entries arrive, name their cells in one grammar, and are written so that they can be read.
#include "state/experiment.h"
#include "values/cell_words.h"
#include "values/parameter.h"
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

TEST_CASE("Conditions of stop.when are read with names, come back as text, and leave other scenarios' meaning alone") {
  const auto withStop = [](const std::string& stop) {
    return "morula: 1\nname: x\ndna: |\n  START: a0\n  g1(a0|a0)\nnames: {egg: P0, daughters: [a, p]}\nstop: " + stop +
           "\n";
  };
  const Scenario s = read(withStop("{time: 3, every: 0.5, when: [{born: cell P0a}, {cells: 4, of: a0, after: 1}]}"));
  REQUIRE(s.scene.stop.when.size() == 2);
  CHECK(s.scene.stop.when[0].of[0].path == CellPath::parse("A"));
  CHECK(morula::scenario::stopText(s.scene.stop.when[1], s.names) == "{cells: 4, of: substance a0}");
  CHECK(morula::scenario::stopText(s.scene.stop.when[0], s.names) == "{born: cell P0a}");
  CHECK(readScenario(s.resolved, "resolved.yaml", "", {}).meaning == s.meaning);
  CHECK(read(withStop("{time: 3}")).meaning != s.meaning);
  CHECK(read(withStop("{when: [{born: cell P0a}]}")).scene.stop.when.size() == 1);  // it suffices alone

  const auto refused = [&](const std::string& stop, const std::string& why) {
    CAPTURE(stop);
    CHECK_THAT(complaints(withStop(stop)), ContainsSubstring(why));
  };
  refused("{every: 1}", "needs at least one of");
  refused("{time: 1, every: 1}", "has no effect without when");
  refused("{when: []}", "stop.when");
  refused("{when: [{}]}", "says no condition; needs one of touch, part, born, cells, measure or rest");
  refused("{when: [{born: cell P0a, cells: 3}]}", "stands beside born");
  refused("{when: [{born: cell P0x}]}", "no cell is called 'P0x'");
  refused("{when: [{touch: [cell P0a, cell P0p]}]}", "needs cells that can touch; add 'contact: {}' to physics");
  refused("{when: [{touch: cell P0a}]}", "is no pair of cells");
  refused("{when: [{cells: 0}]}", "a whole number from 1 on");
  refused("{when: [{measure: sphericity, above: 1}]}", "would find nothing to measure; needs");
  refused("{when: [{measure: nonsense, above: 1}]}", "nonsense");
  refused("{when: [{measure: position_rmsd, below: 1}]}", "is known after a run alone; needs another measure");
  refused("{when: [{measure: count of a0}]}", "has no bound");
  refused("{when: [{measure: count of a9, above: 1}]}", "a9");
  refused("{when: [{cells: 3, off: a0}]}", "off");
}

TEST_CASE("Division rules call cells by name, and come back by path") {
  const auto withRules = [](const std::string& rules) {
    return "morula: 1\nname: x\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cycles: 3}\n"
           "physics: {}\nnames: {egg: P0, daughters: [a, p]}\ndivision: {rules: " +
           rules + "}\n";
  };
  const Scenario s = read(withRules("[{of: cell P0p, share: 0.6}, {of: [a0, clone P0a], share: 0.4}]"));
  const auto& rules = s.scene.mechanics->division.rules;
  REQUIRE(rules.size() == 2);
  CHECK(rules[0].of.empty());
  CHECK(rules[0].cells[0].path == CellPath::parse("B"));
  CHECK(rules[1].of == std::vector<std::string>{"a0"});
  CHECK(rules[1].cells[0].kind == CellSelection::Kind::clone);
  CHECK(readScenario(s.resolved, "resolved.yaml", "", {}).meaning == s.meaning);
  CHECK(read(withRules("[{of: substance a0, share: 0.6}]")).meaning ==
        read(withRules("[{of: a0, share: 0.6}]")).meaning);
  CHECK_THAT(complaints(withRules("[{of: cell P0x, share: 0.6}]")),
             ContainsSubstring("division.rules[0].of: no cell is called 'P0x'"));
  CHECK_THAT(complaints(withRules("[{of: substance a7, share: 0.6}]")),
             ContainsSubstring("the DNA has no substance 'a7'"));
  CHECK_THAT(complaints(withRules("[{of: cells P0a, share: 0.6}]")), ContainsSubstring("did you mean cell P0a?"));
}

TEST_CASE("Measures select cells by the same words, and keep their names by path") {
  const auto withMeasures = [](const std::string& measures) {
    return "morula: 1\nname: x\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(skin|a0)\nstop: {cycles: 3}\nphysics: {}\n"
           "names: {cells: {A: ABa, B: skin, AA: B}}\nrecord: {measures: " +
           measures + "}\n";
  };
  const auto measuresOf = [&](const std::string& measures) { return read(withMeasures(measures)).record.measures; };
  using Names = std::vector<std::string>;
  CHECK(measuresOf("[count of clone ABa, count of path AB*, count of substance skin]") ==
        Names{"count of A*", "count of AB*", "count of skin"});
  CHECK(measuresOf("[count of AA, count of a0, count of ABa, count of generation 1]") ==
        Names{"count of AA", "count of a0", "count of A", "count of generation 1"});
  CHECK_THAT(complaints(withMeasures("[count of skin]")),
             ContainsSubstring(
                 "'skin' is the name of a cell (path B) and a substance; write 'cell skin' or 'substance skin'"));
  CHECK_THAT(complaints(withMeasures("[count of B]")),
             ContainsSubstring("'B' is the name of a cell (path AA) and a path; write 'cell B' or 'path B'"));
  CHECK_THAT(complaints(withMeasures("[count of cell ABx]")),
             ContainsSubstring("no cell is called 'ABx'; did you mean"));
}

TEST_CASE("Genes that are read at birth are part of a scenario's meaning, and need no lengths from birth") {
  const std::string scene = "morula: 1\nname: x\ndna: 'START: a0'\nstop: {time: 1}\n";
  const Scenario late = read(scene), early = read(scene + "cycle: {first: at-birth}\n");
  CHECK(early.scene.cycle.first == FirstCycle::atBirth);
  CHECK(early.meaning != late.meaning);
  CHECK(read(scene + "cycle: {first: after-length}\n").meaning == late.meaning);
  CHECK_THAT(complaints(scene + "cycle: {first: at-birth, at-birth: {a0: 2}}\n"),
             ContainsSubstring("cycle.at-birth: cells whose genes are read at birth have no first cycle to wait for"));
}
