// Comparisons of studies with known values.
#include <algorithm>

#include "analysis/compare_parts.h"
#include "analysis/study_comparison.h"
#include "base/random.h"
#include "catch.h"
#include "database/database.h"
#include "database/store_error.h"
#include "statistics/equivalence.h"
#include "store/result_file.h"
#include "study_db.h"
#include "system/usage_error.h"
#include "temporary_folder.h"

using namespace morula;

namespace {

/// Returns noise of seeds 1 to 10, with mean 0 over these seeds.
double noise(int seed, std::uint64_t key) {
  double sum = 0;
  for (std::uint32_t s = 1; s <= 10; ++s) sum += randomNormal({key, {}}, s);
  return randomNormal({key, {}}, static_cast<std::uint32_t>(seed)) - sum / 10;
}

StudyComparison compared(const MadeStudy& study, const CompareOptions& options = {}) {
  const TemporaryFolder folder;
  writeStudy(study, folder / "study.db");
  return compareStudy(readStudyResults(folder / "study.db"), options);
}

/// Returns a study like the project's own: seeds change nothing under `longest`, sisters always touch, clones are
/// tighter under `longest` by 4.5 %, and connections change nothing.
MadeStudy policies() {
  MadeStudy study;
  study.axes = {{"division", {"longest", "random"}}, {"connections", {"none", "both"}}};
  study.seedless = [](const std::vector<int>& levels) { return levels[0] == 0; };
  study.values = [](const std::vector<int>& levels, int seed) {
    const double z = noise(seed, 11), own = noise(seed, std::uint64_t(20 + levels[1]));
    const bool random = levels[0] == 1;
    return Values{{"clone_radius", random ? 1 / 0.955 * (1 + 0.005 * z + 0.001 * own) : 1},
                  {"sister_contact", random && seed == 3 ? 0.994 : 1}};
  };
  return study;
}

const PairComparison& pairOf(const StudyComparison& c, const std::string& measure, const std::string& axis) {
  for (const PairComparison& p : c.pairs)
    if (c.measureName(p.measure) == measure && c.results.axes[p.axis].name == axis) return p;
  throw std::runtime_error("no such pair");
}

void checkCorrectedByHolm(const std::vector<PairComparison>& pairs) {
  std::vector<double> p;
  for (const PairComparison& pair : pairs) p.push_back(pair.paired.p);
  const auto corrected = correctHolm(p);
  for (std::size_t i = 0; i < p.size(); ++i) CHECK(pairs[i].corrected == corrected[i]);
}

bool says(const std::vector<std::string>& lines, const std::string& sentence) {
  return std::ranges::find(lines, sentence) != lines.end();
}

/// Returns true if a sentence has this beginning, part and end.
bool says(const std::vector<std::string>& lines, const std::string& begin, const std::string& part,
          const std::string& end = "") {
  return std::ranges::any_of(lines, [&](const std::string& line) {
    return line.starts_with(begin) && line.find(part) != line.npos && line.ends_with(end);
  });
}

/// Returns the sentences of a comparison, and shows them if a check fails.
std::vector<std::string> shownVerdicts(const StudyComparison& c) {
  auto verdicts = verdictsOf(c);
  for (const auto& line : verdicts) UNSCOPED_INFO(line);
  return verdicts;
}

}  // namespace

TEST_CASE("Sentences say what differs, what does not and what tells nothing") {
  const auto c = compared(policies());
  const auto verdicts = shownVerdicts(c);
  CHECK(says(verdicts, "clone_radius: 4.5 % tighter under longest (", "), every one of 10 pairs: difference -0.",
             " after Holm"));
  CHECK(says(verdicts, "sister_contact is 0.994 to 1 everywhere, so it distinguishes no conditions"));
  CHECK(says(verdicts, "clone_radius: no difference is shown between none (", "", ", n = 10"));
  CHECK(verdicts[0].starts_with("division: decides on clone_radius (η² "));  // the axes come first
  CHECK(
      verdicts[1].starts_with("connections: no effect is shown on clone_radius (η² "));  // sister_contact shows nothing
  CHECK(verdicts.size() == 8);
  CHECK_THAT(verdicts[4], ContainsSubstring("no difference is shown"));  // after the sentences about known effects
  CHECK_THAT(verdicts[5], ContainsSubstring("common random numbers: the interval of a paired difference is 0."));
  CHECK(verdicts[6].starts_with("two groups: values lie in two groups in the samples of 3 of 7 intervals"));  // sisters
  CHECK(
      verdicts[7] ==
      "intervals: with 10 runs a 95 % interval holds the mean in 95 of 100 studies if values are normal, in 91 if they "
      "are exponential, in 86 if they are log-normal, and in 65 if one run in ten ends far from all others; so few runs "
      "need not show which it is");
}

TEST_CASE("Conditions that differ most come first, and those without values last") {
  MadeStudy study;
  study.axes = {{"where", {"middle", "low", "nothing", "near low", "high"}}};
  study.seeds = 3;
  study.values = [](const std::vector<int>& levels, int seed) -> Values {
    const double places[] = {5, 0, 0, 0.5, 9.8};  // low and high are farthest apart
    if (levels[0] == 2) return {};
    return {{"neighbours", places[levels[0]] + 0.01 * seed}, {"sphericity", 1}};
  };
  // The middle is farther from low and high than `near low` is.
  CHECK(byDifference(compared(study)) == std::vector<std::size_t>{1, 4, 0, 3, 2});
}

TEST_CASE("A condition whose seeds change nothing has one run, is named, and has no interval") {
  const auto c = compared(policies());
  REQUIRE(c.seedless.size() == 2);
  CHECK(c.results.nameOf(c.results.conditions[c.seedless[0]]) == "longest, none");
  int with = 0, without = 0;
  for (const ConditionSummary& s : c.conditions) {
    CHECK(s.values.size() == 10);
    const bool seedless = c.results.conditions[s.condition].levels[0] == 0;
    CHECK(s.distinct == (seedless ? 1 : 10));
    ++(s.interval ? with : without);
    CHECK(s.interval.has_value() == !seedless);
  }
  CHECK(with == 4);
  CHECK(without == 4);
  CHECK_THAT(textOf(describe(c)),
             ContainsSubstring("longest, none") && ContainsSubstring("conditions that seeds do not change"));
}

TEST_CASE("Pairs are of one seed, in the mean over the other axes, and the same numbers as by hand") {
  MadeStudy study = policies();
  study.seedless = {};
  const auto c = compared(study);
  const auto& pair = pairOf(c, "clone_radius", "connections");
  std::vector<double> none, both;
  for (int seed = 1; seed <= 10; ++seed) {
    const auto mean = [&](int connections) {
      return 0.5 * (study.values({0, connections}, seed)["clone_radius"] +
                    study.values({1, connections}, seed)["clone_radius"]);
    };
    none.push_back(mean(0)), both.push_back(mean(1));
  }
  CHECK(pair.paired.difference == Approx(mean(none) - mean(both)).margin(1e-15));
  CHECK(pair.paired.p == Approx(comparePaired(none, both).p));
  CHECK(pair.unpaired->interval->low == Approx(compareUnpaired(none, both).interval->low));
  CHECK(*pair.intervalRatio() < 0.5);  // seeds share most of what varies
  checkCorrectedByHolm(c.pairs);
  CHECK(c.pairs.size() == 4);
}

TEST_CASE("Within: the levels are compared at each level of the other axis, too") {
  const auto c = compared(policies(), {.measures = {"clone-radius"}, .within = true});
  CHECK(c.pairs.size() == 6);
  CHECK(c.pairs[1].at[1] == 0);
  CHECK(says(verdictsOf(c), "clone_radius: 4.5 % tighter under longest (",
             " with connections: none, every one of 10 pairs: "));
  const auto one = compared(policies(), {.by = {"division"}, .within = true});
  CHECK(one.pairs.size() == 2);  // in the mean over connections, which are not compared
}

TEST_CASE("Failed and missing runs are named, and their partners are left out") {
  MadeStudy study = policies();
  study.trouble = [](const std::vector<int>& levels, int seed) -> std::string {
    if (levels == std::vector{1, 0} && seed == 4) return "failed";
    if (levels == std::vector{1, 1} && (seed == 4 || seed == 7)) return "missing";
    return "";
  };
  const auto c = compared(study);
  const auto troubles = troublesOf(c.results);
  CHECK(says(troubles, "failed  random, none, seed 4: numerical failure: too fast"));
  CHECK(says(troubles, "missing  random, both, seed 7"));
  CHECK(troubles.size() == 3);
  const std::string text = textOf(describe(c));
  CHECK(text.find("failed  random") < text.find("clone_radius"));
  CHECK(pairOf(c, "clone_radius", "division").of.size() == 9);  // seed 7 has one connection left
  CHECK(pairOf(c, "clone_radius", "connections").of.size() ==
        9);  // seeds 4 and 7 have longest alone, which is one pair
}

TEST_CASE("What seeds change on neither side is exact, and is no test") {
  MadeStudy study = policies();
  study.seedless = [](const std::vector<int>&) { return true; };
  const auto c = compared(study);
  const auto& pair = pairOf(c, "clone_radius", "division");
  CHECK(pair.known == Known::exact);
  CHECK(pair.of.size() == 1);
  CHECK(says(verdictsOf(c), "clone_radius: ", " tighter under longest (",
             "), exactly, because seeds change neither side"));
  const Json json = toJson(c);
  CHECK(json["pairs"][0]["p"].is_null());
  CHECK(json["pairs"][0]["low"].is_null());
}

TEST_CASE("One seed is one run, and nothing is claimed of it") {
  MadeStudy study = policies();
  study.seeds = 1;
  const auto c = compared(study);
  CHECK(pairOf(c, "clone_radius", "division").known == Known::oneSeed);
  CHECK(c.seedless.empty());
  for (const ConditionSummary& s : c.conditions) CHECK(!s.interval);
}

TEST_CASE("Conditions that mean the same are the same runs, and no comparison") {
  MadeStudy study = policies();
  study.seedless = {};
  study.sameAs = [](const std::vector<int>& levels) { return std::vector{levels[0], 0}; };
  const auto c = compared(study);
  CHECK(says(troublesOf(c.results), "equal runs  longest, none = longest, both"));
  CHECK(pairOf(c, "clone_radius", "connections").sameRuns);
  CHECK(says(verdictsOf(c), "clone_radius: the runs of none and both are the same"));
}

TEST_CASE("Main effects and interaction are those of the design") {
  MadeStudy study;
  study.axes = {{"a", {"1", "2", "3"}}, {"b", {"x", "y"}}};
  study.values = [](const std::vector<int>& l, int seed) {
    return Values{{"volume", 10 + l[0] + 2 * l[1] + (l[0] == 2 && l[1] == 1 ? 1.5 : 0) + noise(seed, 5) +
                                 0.1 * noise(seed, std::uint64_t(30 + 2 * l[0] + l[1]))}};
  };
  const auto c = compared(study);
  REQUIRE(c.effects.size() == 1);
  const auto& effects = c.effects[0];
  CHECK(effects.untested.empty());
  CHECK(effects.means[0][2] - effects.means[0][0] == Approx(2.75).margin(0.2));
  REQUIRE(effects.analysis.effects.size() == 3);
  for (const FactorEffect& e : effects.analysis.effects) CHECK(*e.p < 1e-6);
  const auto verdicts = shownVerdicts(c);
  CHECK(verdicts[0].starts_with("a: its effect on volume depends on b (interaction, η² "));
  CHECK_THAT(verdicts[0], ContainsSubstring("partial η² "));
  CHECK(verdicts[0].size() < 140);
  CHECK(verdicts[1].starts_with("b: its effect on volume depends on a (interaction, η² "));
  // No sentence is about the mean over an axis on which the effect depends. Every pair of levels is compared at each
  // level of the other axis.
  for (const auto& line : verdicts) CHECK(!line.starts_with("volume: "));
  CHECK(c.split.size() == 2 * 3 + 3);
  checkCorrectedByHolm(c.split);
  CHECK_THAT(textOf(describe(c)), ContainsSubstring("volume by a at each level of b"));
  const Json json = toJson(c);
  CHECK(json["split"].size() == 9);
  // One small table shows both axes; text and JSON say the same of it.
  REQUIRE(json["interactions"].size() == 1);
  const Json& both = json["interactions"][0];
  CHECK(both["measure"] == "volume");
  CHECK(both["eta_squared"] == effects.analysis.effects[2].share);
  CHECK(both["means"]["3"]["y"].get<double>() - both["means"]["3"]["x"].get<double>() == Approx(3.5).margin(0.3));
  CHECK(both["levels_that_differ"] == Json({{"x", "every two"}, {"y", "every two"}}));
  CHECK(both["others_that_differ"] == Json({{"1", "x and y"}, {"2", "x and y"}, {"3", "x and y"}}));
  const std::string tables = textOf(interactionTables(c));
  CHECK_THAT(tables, ContainsSubstring("volume [length³] by a and b, interaction η² 0.") && ContainsSubstring("b x") &&
                         ContainsSubstring("every two") && ContainsSubstring("x and y"));
  CHECK_THAT(textOf(describe(c)), ContainsSubstring(tables));
  // The measure has a plain name, a unit and a meaning beside its key.
  CHECK(json["measures"][0]["measure"] == "volume");
  CHECK(json["measures"][0]["unit"] == "length³");
  CHECK_THAT(json["measures"][0]["meaning"].get<std::string>(), ContainsSubstring("Volume of all cells"));
  CHECK_THAT(textOf(describe(c)), ContainsSubstring("Volume of all cells"));
}

TEST_CASE("Where what one axis does depends on another, levels with no difference have a bound") {
  MadeStudy study;
  study.axes = {{"a", {"1", "2", "3"}}, {"b", {"x", "y", "z"}}};
  study.values = [](const std::vector<int>& l, int seed) {
    return Values{{"volume", 10 + (l[1] == 1 && l[0] == 2 ? 3 : 0) + noise(seed, 5) +
                                 0.1 * noise(seed, std::uint64_t(30 + 3 * l[0] + l[1]))}};
  };
  const Json both = toJson(compared(study))["interactions"];
  REQUIRE(both.size() == 1);
  CHECK(both[0]["levels_that_differ"]["y"] == "1 and 3, 2 and 3");
  for (const char* level : {"x", "z"})
    CHECK(both[0]["levels_that_differ"][level].get<std::string>().starts_with("none shown (±0."));
  for (const char* level : {"1", "2"})
    CHECK(both[0]["others_that_differ"][level].get<std::string>().starts_with("none shown (±0."));
}

TEST_CASE(
    "An axis that decides says how much, with an interval, and between which levels; one that does not, at "
    "most how much") {
  MadeStudy study;
  study.axes = {{"a", {"1", "2", "3"}}, {"b", {"x", "y"}}};
  study.cells = [](const std::vector<int>& l) { return 60 + l[0]; };
  study.values = [](const std::vector<int>& l, int seed) {
    const double z = noise(seed, 5) + 0.3 * noise(seed, std::uint64_t(30 + 3 * l[0] + l[1]));
    return Values{{"clone_radius", 10 + (l[0] == 2 ? 1 : 0) + z}, {"clone_spread", 1 + 0.1 * z}};
  };
  const auto verdicts = shownVerdicts(compared(study));
  const auto line = [&](const std::string& begin) {
    const auto at = std::ranges::find_if(verdicts, [&](const auto& v) { return v.starts_with(begin); });
    return at == verdicts.end() ? std::string() : *at;
  };
  CHECK_THAT(line("a: decides on clone_radius (η² 0."),
             ContainsSubstring(", partial η² 0.") && ContainsSubstring(", 95 % interval 0.") &&
                 ContainsSubstring("): 1 10, 2 10, 3 11: 1 and 3, 2 and 3 differ"));
  CHECK_THAT(line("b: no effect is shown on "), ContainsSubstring("clone_radius (η² below 0.001") &&
                                                    ContainsSubstring(", partial η² at most 0.") &&
                                                    ContainsSubstring("clone_spread (η² "));
  CHECK(says(verdicts,
             "numbers of cells differ between conditions, 60 to 62 in the mean; clone_radius changes with "
             "the number of cells, even if cells are arranged alike"));
  study.cells = [](const std::vector<int>&) { return 64; };
  study.trouble = [](const std::vector<int>& l, int seed) { return l[0] == 1 && seed == 3 ? "failed" : ""; };
  for (const auto& sentence : verdictsOf(compared(study))) CHECK(!sentence.starts_with("numbers of cells"));
}

TEST_CASE("A difference that is shown and within the margin is one sentence") {
  const auto c = compared(policies(), {.margins = {"0.055"}});
  int sentences = 0;
  for (const auto& line : verdictsOf(c)) {
    if (!line.starts_with("clone_radius: ")) continue;
    ++sentences;
    if (line.find("tighter under longest") != line.npos)
      CHECK_THAT(line, ContainsSubstring("; a small difference, equivalent within ±0.055, 90 % interval "));
    else
      CHECK_THAT(line,
                 ContainsSubstring("no difference is shown") && ContainsSubstring("; equivalent within ±0.055, "));
  }
  CHECK(sentences == 2);
}

TEST_CASE("Equivalent, different or not decided, by margins of a number, a share of the mean or a measure") {
  const auto verdictWith = [](const std::string& margin) {
    const auto c = compared(policies(), {.margins = {margin}});
    const auto& pair = pairOf(c, "clone_radius", "division");
    return pair.equivalence ? std::string(nameOf(pair.equivalence->verdict)) : "none";
  };
  CHECK(verdictWith("0.055") == "equivalent");
  CHECK(verdictWith("5.3%") == "equivalent");
  CHECK(verdictWith("clone-radius=5.3%") == "equivalent");
  CHECK(verdictWith("0.01") == "different");
  CHECK(verdictWith("1%") == "different");
  CHECK(verdictWith("0.047") == "not decided");
  CHECK(verdictWith("sister_contact=0.005") == "none");
}

TEST_CASE("A margin wider than all that was seen is refused, or is not tested where it is for all measures") {
  const auto c = compared(policies(), {.margins = {"10%"}});
  const auto& pair = pairOf(c, "clone_radius", "division");
  CHECK(pair.equivalence->verdict == Equivalent::untested);
  CHECK(says(shownVerdicts(c), "clone_radius: 4.5 % tighter under longest (", "",
             "; equivalence is not tested, because ±0.102 is wider than the range of all values"));
  const auto message = [](const std::string& margin) -> std::string {
    try {
      compared(policies(), {.margins = {margin}});
      return "";
    } catch (const UsageError& error) { return error.what(); }
  };
  CHECK(message("5.3%").empty());
  CHECK_THAT(message("clone_radius=10%"),
             ContainsSubstring("--equivalent: ±0.102 of clone_radius is wider than the range of all its values (1 to "
                               "1.05") &&
                 ContainsSubstring("), so any two conditions would pass; needs a margin below 0.05"));
  // A value that all runs have is equivalent within any margin.
  MadeStudy same;
  same.axes = {{"a", {"1", "2"}}};
  same.values = [](const std::vector<int>&, int) { return Values{{"cells", 8}}; };
  CHECK(compared(same, {.margins = {"cells=1"}}).pairs[0].equivalence->verdict == Equivalent::yes);
}

TEST_CASE("Sphericity is compared on its distance from 1, by margins, percentages and what tells nothing") {
  MadeStudy study;
  study.axes = {{"shape", {"round", "flat"}}};
  study.values = [](const std::vector<int>& levels, int seed) {
    return Values{{"sphericity", (levels[0] == 0 ? 0.996 : 0.992) + 1e-5 * noise(seed, 5 + std::uint64_t(levels[0]))}};
  };
  const auto c = compared(study, {.margins = {"10%"}});
  const auto verdicts = shownVerdicts(c);
  // 0.004 and 0.008 from 1: half of it, though the values themselves differ by 0.4 %.
  CHECK(
      says(verdicts, "sphericity: rounder by 50 % of 1 − sphericity under round (0.996) than under flat (0.992)", ""));
  CHECK(pairOf(c, "sphericity", "shape").equivalence->test.margin == Approx(0.0006).epsilon(1e-3));
  CHECK(pairOf(c, "sphericity", "shape").equivalence->verdict == Equivalent::no);
  for (const auto& line : verdicts) CHECK(line.find("distinguishes no conditions") == line.npos);
}

TEST_CASE("Runs that are one run but for rounding are one path, and have neither interval nor test") {
  MadeStudy study;
  study.axes = {{"settings", {"own", "half-step", "random"}}};
  study.values = [](const std::vector<int>& levels, int seed) {
    const double rounding = 1e-9 * noise(seed, 3 + std::uint64_t(levels[0]));
    if (levels[0] == 2)
      return Values{
          {"clone_radius", 1 + 0.1 * noise(seed, 8)}, {"neighbours", 3}, {"volume", 2 + 0.1 * noise(seed, 9)}};
    return Values{{"clone_radius", 1 + rounding},
                  {"neighbours", 4.5 - 0.5 * levels[0]},
                  {"volume", 2 + 0.1 * levels[0] + rounding}};
  };
  const auto c = compared(study);
  CHECK(c.onePaths == std::vector<std::size_t>{0, 1});
  for (const ConditionSummary& s : c.conditions) {
    CHECK(s.onePath == (s.condition < 2));
    CHECK(s.interval.has_value() == (s.condition == 2 && c.measureName(s.measure) != "neighbours"));
  }
  for (const PairComparison& p : c.pairs) {
    CHECK((p.known == Known::onePath) == (p.b == 1));
    if (p.b == 1) CHECK(!p.corrected);
  }
  const auto verdicts = shownVerdicts(c);
  CHECK(
      says(verdicts,
           "neighbours: 12 % more under own (4.5) than under half-step (4), on one path each: the 10 runs of each are "
           "one run but for rounding"));
  CHECK(says(verdicts, "clone_radius: equal but for rounding under own and half-step"));
  CHECK_THAT(textOf(describe(c)), ContainsSubstring("one path: the runs of these conditions differ") &&
                                      ContainsSubstring("half-step: 10 runs that are one run"));
  CHECK(toJson(c)["one_path"].size() == 2);
  // The family is that of pairs with the condition that varies.
  std::vector<PairComparison> tested;
  for (const PairComparison& p : c.pairs)
    if (p.known == Known::estimated) tested.push_back(p);
  CHECK(tested.size() == 6);
  checkCorrectedByHolm(tested);
  // Runs that are equal but for rounding with every seed are no difference either, though seeds matter.
  study.values = [](const std::vector<int>& levels, int seed) {
    return Values{{"volume", 2 + noise(seed, 9) + (levels[0] == 1 ? 1e-9 * (seed + 5) : 0.1 * levels[0])}};
  };
  const auto copies = compared(study);
  CHECK(copies.onePaths.empty());
  CHECK(copies.pairs[0].known == Known::onePath);
  CHECK(!isDifferent(copies.pairs[0]));
}

TEST_CASE(
    "A rank that jumps where rounding breaks ties does not hide that runs are one path, and one value is no path") {
  MadeStudy study;
  study.axes = {{"settings", {"own", "half-step"}}};
  study.values = [](const std::vector<int>& levels, int seed) {
    const double rounding = 1e-11 * noise(seed, 3);
    return levels[0] == 0 ? Values{{"lineage_space", seed % 3 ? 0.4 : 0.42}, {"mean_pressure", 5 + rounding}}
                          : Values{{"lineage_space", 0.4 + 0.1 * noise(seed, 4)}, {"mean_pressure", 5}};
  };
  const auto c = compared(study);
  CHECK(c.onePaths == std::vector<std::size_t>{0});
}

TEST_CASE("Skewed differences and those of two groups are told where their intervals are") {
  MadeStudy study;
  study.axes = {{"a", {"1", "2"}}};
  study.values = [](const std::vector<int>& levels, int seed) {
    const double far[] = {0.1, 0.2, 0.15, 0.3, 0.12, 0.5, 0.22, 1.1, 0.05, 0.4};
    const double z = 0.01 * noise(seed, 5);
    if (levels[0] == 0) return Values{{"volume", 1 + z}, {"cells", 8}, {"neighbours", 4 + z}};
    return Values{{"volume", 1 + z + far[seed - 1]}, {"cells", seed == 4 ? 7 : 8}, {"neighbours", 4.5 + 2 * z}};
  };
  const auto c = compared(study);
  const auto verdicts = shownVerdicts(c);
  CHECK(says(verdicts, "volume: ", " (skewed), p = "));
  CHECK(says(verdicts, "cells: ", " (two groups), p = 1 after Holm"));
  CHECK(says(verdicts, "neighbours: ", " interval -0.5"));
  CHECK(says(verdicts,
             "skewed: a few values lie far out on one side in the samples of 2 of 8 intervals, which reach farther on "
             "that side than Student's"));
  CHECK(says(verdicts,
             "two groups: values lie in two groups in the samples of 2 of 8 intervals, which are those of the "
             "share of runs in each group"));
  const Json json = toJson(c);
  for (const Json& pair : json["pairs"])
    CHECK(pair["shape"] == (pair["measure"] == "volume"  ? "skewed"
                            : pair["measure"] == "cells" ? "two groups"
                                                         : "plain"));
}

TEST_CASE("Time courses are of the times that all runs share") {
  MadeStudy study = policies();
  study.times = {1, 2, 4};
  const auto c = compared(study);
  REQUIRE(c.courses.size() == 8);
  for (const TimeCourse& course : c.courses) {
    REQUIRE(course.points.size() == 3);
    CHECK(course.points[1].time == 2);
    CHECK(course.points[1].mean == Approx(0.5 * course.points[2].mean));
  }
  CHECK(compared(policies()).courses.empty());
}

TEST_CASE("Other output says the same numbers") {
  const auto c = compared(policies());
  const Json json = toJson(c);
  CHECK(json["conditions"].size() == 8);
  CHECK(json["conditions"][0]["labels"] == Json({{"division", "longest"}, {"connections", "none"}}));
  CHECK(json["conditions"][0]["n"] == 10);
  CHECK(json["conditions"][0]["distinct"] == 1);
  CHECK(json["conditions"][0]["low"].is_null());
  CHECK(json["pairs"][0]["difference"].get<double>() == c.pairs[0].paired.difference);
  CHECK(json["verdicts"].size() == 8);
  const std::string csv = toCsv(c);
  CHECK(std::ranges::count(csv, '\n') == 1 + 80 + 8 + 4 + 2 * 3);  // title, values, conditions, pairs, effects
  CHECK(csv.starts_with(
      "kind,measure,axis:division,axis:connections,by,a,b,seed,time,n,distinct,unit,value,low,high,shape,p,p_holm,"
      "effect,g,higher,lower,unpaired_low,unpaired_high,interval_ratio,margin,p_equivalent_holm,equivalent\n"));
}

TEST_CASE("A measure that is the same in all runs leaves the family, and the p-values of others are as without it") {
  MadeStudy study = policies();
  const auto alone = compared(study, {.measures = {"clone-radius"}});
  const auto values = study.values;
  study.values = [=](const std::vector<int>& levels, int seed) {
    auto all = values(levels, seed);
    all["sister_contact"] = 1;
    return all;
  };
  const auto beside = compared(study);
  CHECK(pairOf(beside, "clone_radius", "division").corrected == pairOf(alone, "clone_radius", "division").corrected);
  CHECK(!pairOf(beside, "sister_contact", "division").corrected);
  CHECK(says(verdictsOf(beside), "sister_contact is 1 everywhere, so it distinguishes no conditions"));
}

TEST_CASE("What the study has not is refused, with what was probably meant") {
  const auto message = [](const CompareOptions& options) -> std::string {
    try {
      compared(policies(), options);
      return "";
    } catch (const UsageError& error) { return error.what(); }
  };
  CHECK(message({.by = {"divison"}}) == "--by: the study has no axis 'divison'; did you mean division?");
  CHECK_THAT(message({.measures = {"mass"}}), ContainsSubstring("it has sister_contact, clone_radius"));
  for (const char* wrong : {"", "0", "-1", "abc", "5%%", "inf", "clone_radius=", "radius=0.1"})
    CHECK_THAT(message({.margins = {wrong}}), ContainsSubstring("--equivalent: "));
  CHECK_THAT(message({.margins = {"0.1", "0.2"}}), ContainsSubstring("two margins"));
}

TEST_CASE("A database that is no study's is refused") {
  const TemporaryFolder folder;
  {
    Database db(folder / "run.db", Database::Mode::create, std::chrono::seconds(1));
    makeTables(db);
  }
  CHECK_THROWS_WITH(readStudyResults(folder / "run.db"), ContainsSubstring("but of no study"));
  CHECK_THROWS_AS(readStudyResults(folder / "none.db"), StoreError);
}

TEST_CASE("A study without axes has conditions and no pairs") {
  MadeStudy study;
  study.values = [](const std::vector<int>&, int seed) { return Values{{"cells", 30. + seed}}; };
  const auto c = compared(study);
  CHECK(c.conditions.size() == 1);
  CHECK(c.conditions[0].mean == 35.5);
  CHECK(c.pairs.empty());
  CHECK_THAT(textOf(describe(c)), ContainsSubstring("cells"));
}
