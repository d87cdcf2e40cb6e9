// Study files: every form of a value, and the mistakes in tests/bad_studies.
#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "files/folders.h"
#include "observation/asked_measure.h"
#include "scenario/schema.h"
#include "studies.h"
#include "study/conditions.h"
#include "study/study_schema.h"
#include "study/study_table.h"
#include "yaml/source_text.h"
// Included last, because of CHECK:
#include "catch.h"

using namespace morula;

namespace {

Study studyOf(const std::string& text) { return studyIn(TemporaryFolder(), text); }

/// Returns the usual study with these measures instead.
Study measuring(const std::string& measures) {
  return studyOf(ballStudyWith("[sister-contact, clone_radius]", measures));
}

scenario::Node nodeOf(const std::string& text) {
  scenario::Problems problems("test");
  const scenario::SourceText source(text, problems);
  auto node = readYaml(source, problems);
  problems.throwIfAny();
  return node;
}

/// Returns kind, style and text of a node, without places.
std::string shapeOf(const scenario::Node& node) {
  std::string text = std::to_string(int(node.kind)) + (node.isPlain() ? "p" : "q") + node.text;
  for (const auto& item : node.items) text += "[" + shapeOf(item) + "]";
  for (const auto& member : node.members) text += "{" + member.key + ":" + shapeOf(member.value) + "}";
  return text;
}

}  // namespace

TEST_CASE("A study says what it is about, and defaults fill in the rest") {
  const Study s = studyOf(ballStudy);
  CHECK(s.name == "balls");
  CHECK(s.bases.size() == 1);
  CHECK(s.bases[0].label == "balls");
  REQUIRE(s.axes.size() == 2);
  CHECK(s.axes[0].name == "division");
  CHECK(s.axes[1].levels[0].label == "none");
  CHECK(s.axes[1].levels[0].overrides.empty());
  REQUIRE(s.axes[1].levels[1].overrides.size() == 2);
  const Override& change = s.axes[1].levels[1].overrides[1];
  CHECK(change.path == "connections.on-division");
  CHECK(change.value == "both");
  CHECK(change.place ==
        s.file + ":6:" + std::to_string(ballStudy.find("both}}") - ballStudy.find("  connections") + 1));
  CHECK(s.seeds == std::vector<std::uint64_t>{1, 2, 3});
  CHECK(s.measures == std::vector<std::string>{"sister_contact", "clone_radius"});
  CHECK(s.when == When{});
  CHECK(s.keep == Kept{HashesKept::end, SamplesKept::end, PicturesKept::none});
  CHECK(s.limits == RunLimits{});
}

TEST_CASE("Seeds are a number, a range, or a list of both, in their order") {
  using Seeds = std::vector<std::uint64_t>;
  CHECK(studyOf(ballStudyWith("1..3", "20080617")).seeds == Seeds{20080617});
  CHECK(studyOf(ballStudyWith("1..3", "[9, 2..4, 1]")).seeds == Seeds{9, 2, 3, 4, 1});
  CHECK(studyOf(ballStudyWith("1..3", "9223372036854775807")).seeds == Seeds{9223372036854775807u});
}

TEST_CASE("Measures may say when they are taken, and limits have units") {
  CHECK(measuring("{names: [cells], when: each-division}").when == When{Moments::eachDivision, 0});
  CHECK(measuring("{names: [cells], when: {every: 0.25}}").when == When{Moments::every, 0.25});
  CHECK(measuring("{names: [cells], when: end}").when == When{});
  CHECK(measuring("[cell.volume, world.volume]").measures == std::vector<std::string>{"cell.volume", "world.volume"});
  for (const auto& [text, bytes] :
       {std::pair{"500M", 500e6}, {"2G", 2e9}, {"1.5G", 1.5e9}, {"3000000", 3e6}, {"4000k", 4e6}})
    CHECK(double(*studyOf(ballStudy + "limits: {memory-per-run: " + text + "}\n").limits.memory) == bytes);
  CHECK(studyOf(ballStudy + "limits: {cpu-per-run: 120}\n").limits.cpu == 120);
}

TEST_CASE("Every measure of every table has one name in studies, and finds its row by it") {
  std::vector<std::string> names;
  for (const AskedMeasure& m : allMeasures()) {
    names.push_back(m.name);
    REQUIRE(findMeasure(m.name)->name == m.name);
    std::string dashed = m.name;
    std::ranges::replace(dashed, '_', '-');
    CHECK(findMeasure(dashed)->name == m.name);
    CHECK(findMeasure(std::string(name(m.scope)) + "." + m.row)->name == m.name);
  }
  CHECK(names.size() == measures<Observation>().size() + measures<CellContext>().size() + measures<Touch>().size());
  std::ranges::sort(names);
  CHECK(std::ranges::adjacent_find(names) == names.end());
  CHECK(!findMeasure("volume"));  // ambiguous: of the organism, or of a cell
  CHECK(findMeasure("volume of cell ABp")->name == "cell.volume of cell ABp");  // the organism's takes no cells
}

TEST_CASE("A measure of cells or pairs may be of some cells alone, and what selects none is said") {
  CHECK(measuring("[shell-share of AAA*, count of skin, elongation of generation 3, cell.volume of s*]").measures ==
        std::vector<std::string>{"shell_share of AAA*", "count of skin", "elongation of generation 3",
                                 "cell.volume of s*"});
  CHECK(
      measuring("[age of clones, clone-radius of generation 3]").measures ==
      std::vector<std::string>{"age of AA*", "age of AB*", "age of BA*", "age of BB*", "clone_radius of generation 3"});
  for (const auto& [measure, message] :
       {std::pair{"lumen of AAA*", "'lumen' measures the whole organism and takes no 'of'"},
        {"clone-radius of AAA*", "'clone-radius' is the mean over all clones; needs 'of generation N'"},
        {"age of genration 3", "selects no cells; did you mean generation 3?"},
        {"shell-share of A*B", "'A*B' selects no cells; needs a path (AAA"},
        {"shell-share of generation x", "is no generation; needs a whole number"},
        {"shel-share of AAA", "did you mean shell_share?"},
        {"count", "say which, as count of skin"}}) {
    const std::string measures = "['" + std::string(measure) + "']";
    CHECK_THROWS_AS(measuring(measures), InputError);
    CHECK_THROWS_WITH(measuring(measures), ContainsSubstring(message));
  }
}

TEST_CASE("A selection has the cells that it says") {
  const auto has = [](const char* selection, const char* path, const char* substances) {
    return parseSelection(selection).has(CellPath::parse(path), substances);
  };
  CHECK(has("AB", "AB", ""));
  CHECK(!has("AB", "ABA", ""));
  CHECK(has("AB*", "ABA", ""));
  CHECK(has("AB*", "AB", ""));
  CHECK(!has("AB*", "AA", ""));
  CHECK(has("generation 2", "AB", ""));
  CHECK(!has("generation 2", "ABA", ""));
  CHECK(has("generation 0", "", ""));
  CHECK(has("skin", "A", "s1 skin"));
  CHECK(!has("skin", "A", "s1 skins"));
  CHECK(has("s*", "A", "b s1"));
  CHECK(!has("ABC", "AB", "AB"));  // ABC is a substance
  CHECK(has("clones", "AB", ""));
  CHECK(!has("clones", "A", ""));
  for (const char* text : {"AB", "AB*", "generation 2", "skin", "s*", "clones"})
    CHECK(parseSelection(text).text() == text);
}

TEST_CASE("A value in a study is the same value in an override") {
  for (const char* text : {"longest", "0.5", "-1e-3", "'0.5'", "\"a: b\"", "[1, 0, 0]", "{axis: [1, 0, 0]}", "{}", "[]",
                           "null", "'null'", "{of: [skin, 'P*'], plane: random, why: null}",
                           "{a: 'it''s \"so\"', 'b c': [[1], []]}", "|\n  START: a0\n  g1(a0|a0)\n",
                           "a text, with [brackets] and {braces}", "why:\n  - one\n  - '# no remark'\n", "'-'"}) {
    CAPTURE(text);
    const auto node = nodeOf(text);
    const std::string line = study::overrideText(node);
    CAPTURE(line);
    scenario::Problems problems("test");
    const auto again = readYamlValue(line, "option", problems);
    CHECK(problems.empty());
    CHECK(shapeOf(again) == shapeOf(node));
    CHECK(line.find('\n') == line.npos);
  }
}

TEST_CASE("Within brackets a text that would end there is put in quotes") {
  CHECK(study::overrideText(nodeOf("why:\n  - one, two\n  - [a]\n")) == R"({why: ["one, two", [a]]})");
}

TEST_CASE("A study is told from a scenario by its name or its first key") {
  const TemporaryFolder folder;
  writeText(folder / "a.yaml", "# about\n\nmorula-study: 1\n");
  writeText(folder / "b.yaml", lineageScenario);
  writeText(folder / "c.study.yaml", "");
  CHECK(isStudy(folder / "a.yaml"));
  CHECK_FALSE(isStudy(folder / "b.yaml"));
  CHECK(isStudy(folder / "c.study.yaml"));
  CHECK_FALSE(isStudy(folder / "nothing.yaml"));
  CHECK_THROWS_WITH(loadScenario(folder / "a.yaml"), ContainsSubstring("the file is a study"));
  CHECK_THROWS_WITH(loadStudy(folder / "b.yaml"), ContainsSubstring("the file is a scenario"));
  CHECK_THROWS_AS(loadStudy(folder / "nothing.yaml"), FileError);
}

TEST_CASE("Scenarios of a study lie in its folder unless that is allowed otherwise") {
  const TemporaryFolder folder, other;
  writeText(other / "balls.yaml", ballScenario);
  writeText(folder / "s.study.yaml", ballStudyWith("balls.yaml", "'" + (other / "balls.yaml").string() + "'"));
  CHECK_THROWS_WITH(makePlan(loadStudy(folder / "s.study.yaml"), {.predict = false}),
                    ContainsSubstring("lies outside"));
  CHECK(makePlan(loadStudy(folder / "s.study.yaml", true), {.predict = false}).conditions.size() == 4);
}

TEST_CASE("bad study files are refused with the expected messages, all at once") {
  namespace fs = std::filesystem;
  const fs::path folder = "tests/bad_studies";
  auto files = filesBelow(folder, ".yaml");
  std::erase_if(files, [](const fs::path& file) { return !file.string().ends_with(".study.yaml"); });
  REQUIRE(files.size() >= 25);
  for (const auto& file : files) {
    INFO(file.string());
    std::string message = "accepted";
    try {
      makePlan(loadStudy(file), {.predict = false});
    } catch (const InputError& error) { message = error.what(); }
    CHECK(message + "\n" == readText(fs::path(file).replace_extension(".expected")));
  }
}

TEST_CASE("The study to begin with loads, and the table for people is up to date") {
  const TemporaryFolder folder;
  writeText(folder / "organism.yaml", starterScenario("organism"));
  writeText(folder / "s.study.yaml", starterStudy("first", "organism.yaml"));
  const Plan plan = makePlan(loadStudy(folder / "s.study.yaml"), {.predict = false});
  CHECK(plan.study.name == "first");
  CHECK(plan.replicates.size() == 40);
  CHECK(readText("scenarios/STUDIES.md") == studyKeysAsMarkdown());
}

TEST_CASE("The schema knows the keys that the reader knows, and requires the same") {
  const auto schema = parseJson(studySchema());
  for (const char* key : {"morula-study", "name", "base", "seeds", "measures"}) {
    CAPTURE(key);
    CHECK(schema["properties"].contains(key));
    CHECK(std::ranges::count(schema["required"], Json(key)) == 1);
    std::string without = "morula-study: 1\nname: balls\nbase: balls.yaml\nseeds: 1\nmeasures: [cells]\n";
    const auto at = without.find(std::string(key) + ":");
    without.erase(at, without.find('\n', at) - at + 1);
    CHECK_THROWS_WITH(studyOf(without), ContainsSubstring(std::string(key) + ": is missing"));
  }
  CHECK(schema["required"].size() == 5);
  CHECK(schema["properties"]["keep"]["properties"]["pictures"]["enum"].size() == 3);
}

TEST_CASE("An axis of numbers has levels from the first to the last, which are their own labels") {
  const auto axisOf = [](const std::string& range) {
    return studyOf("morula-study: 1\nname: balls\nbase: balls.yaml\nvary: {drag: " + range +
                   "}\nseeds: 1\nmeasures: [world.volume]\n")
        .axes[0];
  };
  const auto labels = [&](const std::string& range) {
    std::vector<std::string> found;
    for (const Level& level : axisOf(range).levels) found.push_back(level.label);
    return found;
  };
  using Labels = std::vector<std::string>;
  CHECK(labels("{key: physics.drag, from: 1, to: 16, steps: 5, log: true}") == Labels{"1", "2", "4", "8", "16"});
  CHECK(labels("{key: physics.drag, from: 0, to: 1, steps: 3}") == Labels{"0", "0.5", "1"});
  const Level second = axisOf("{key: physics.drag, from: 1, to: 3, steps: 4}").levels[1];
  REQUIRE(second.overrides.size() == 1);
  CHECK(second.overrides[0].path == "physics.drag");
  CHECK(second.overrides[0].value == "1.66667");
  CHECK(second.label == second.overrides[0].value);  // a level computes what its label says

  const auto refused = [&](const std::string& range, const std::string& why) {
    CAPTURE(range);
    CHECK_THROWS_WITH(axisOf(range), Catch::Contains(why));
  };
  refused("{key: physics.drag, from: 0, to: 1, steps: 3, log: true}", "> 0");
  refused("{key: physics.drag, from: 1, to: 2}", "steps: is missing");
  refused("{key: physics.drag, to: 2, steps: 3}", "from: is missing");
  refused("{key: physics.drag, from: 1, to: 2, steps: 1}", "2 to 1000");
  refused("{key: physics.drag, from: 1, to: 1, steps: 3}", "from and to are the same");
  refused("{key: physics.drag, from: 1, to: 1.000001, steps: 9}", "two levels are the same in six digits");
  refused("{key: seed, from: 1, to: 2, steps: 2}", "cannot be varied");
  refused("{key: physics.drag, from: 1, to: 2, steps: 2, step: 1}", "step");
  refused("{key: physics.drag, from: 1, to: 2, steps: 2, log: maybe}", "needs true or false");
}

TEST_CASE("Combinations that are left out have no condition, and numbers of the others follow each other") {
  const std::string head =
      "morula-study: 1\nname: balls\nbase: balls.yaml\nvary:\n"
      "  drag: {low: {physics.drag: 1}, high: {physics.drag: 2}, max: {physics.drag: 3}}\n"
      "  step: {auto: {}, short: {physics.time_step: 0.0009765625}}\n"
      "seeds: 1\nmeasures: [world.volume]\n";
  const auto names = [&](const std::string& out) {
    const Study study = studyOf(head + "leave-out: " + out + "\n");
    std::vector<std::string> found;
    for (const Condition& condition : study::conditionsOf(study)) {
      CHECK(condition.number == found.size());
      found.push_back(condition.labels[0] + " " + condition.labels[1]);
    }
    CHECK(study::countConditions(study) == found.size());
    return found;
  };
  using Names = std::vector<std::string>;
  CHECK(names("[{drag: high, step: short}]") == Names{"low auto", "low short", "high auto", "max auto", "max short"});
  CHECK(names("[{drag: [high, max], step: short}]") == Names{"low auto", "low short", "high auto", "max auto"});
  CHECK(names("[{drag: high}, {step: auto}]") == Names{"low short", "max short"});
  const auto refused = [&](const std::string& rest, const std::string& why) {
    CHECK_THROWS_WITH(studyOf(head + rest + "\n"), Catch::Contains(why));
  };
  refused("leave-out: [{drga: high}]", "did you mean drag?");
  refused("leave-out: [{drag: hihg}]", "did you mean high?");
  refused("leave-out: [{}]", "is no combination");
  // A mistake elsewhere is told, and leads to no further one.
  const auto complaint = [&](const std::string& text) {
    try {
      studyOf(text);
    } catch (const InputError& error) { return std::string(error.what()); }
    return std::string();
  };
  CHECK_THAT(complaint(head + "leave-out: [{drag: [low, high, mxa]}]\n"),
             Catch::Contains("did you mean max?") && !Catch::Contains("no combination to run"));
  std::string bad = head + "leave-out: [{drag: high}]\n";
  bad.replace(bad.find("auto: {}"), 8, "1/2: {}");
  bad.replace(bad.find("short:"), 6, "1/4:");
  CHECK_THAT(complaint(bad), Catch::Contains("is no label") && !Catch::Contains("no combination to run"));
  refused("leave-out: [{drag: [low, high, max]}]", "leaves no combination to run");
  refused("leave-out: [{drag: max}]\ncheck: [{measure: world.volume, at: {drag: max, step: auto}, mean: 1, within: 1}]",
          "names a combination that leave-out leaves out");
}

TEST_CASE("A study that leaves combinations out is planned, and its plan is read again as it was") {
  const TemporaryFolder folder;
  const Plan plan = makePlan(studyIn(folder,
                                     "morula-study: 1\nname: balls\nbase: balls.yaml\nvary:\n"
                                     "  drag: {low: {physics.drag: 1}, high: {physics.drag: 2}}\n"
                                     "  step: {auto: {}, short: {physics.time_step: 0.0009765625}}\n"
                                     "leave-out: [{drag: low, step: short}]\n"
                                     "seeds: 1..2\nmeasures: [world.volume]\n"),
                             {.predict = false});
  CHECK(plan.conditions.size() == 3);
  CHECK(plan.replicates.size() == 6);
  const Plan again = readPlan(writePlan(plan), "plan.json");
  CHECK(again.id == plan.id);
  CHECK(again.conditions[1].labels == std::vector<std::string>{"high", "auto"});
}
