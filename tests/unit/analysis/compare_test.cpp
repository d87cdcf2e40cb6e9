// Comparisons of studies with known values.
#include <algorithm>

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
  CHECK(verdicts.size() == 6);
  CHECK_THAT(verdicts[4], ContainsSubstring("no difference is shown"));  // after the sentences about known effects
  CHECK_THAT(verdicts.back(), ContainsSubstring("common random numbers: the interval of a paired difference is 0."));
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
  CHECK_THAT(verdicts[0], ContainsSubstring("partial η² ") && ContainsSubstring(": with b x: 1 ") &&
                              ContainsSubstring(": every two differ; with b y: 1 "));
  CHECK(verdicts[1].starts_with("b: its effect on volume depends on a (interaction, η² "));
  // No sentence is about the mean over an axis on which the effect depends. Every pair of levels is compared at each
  // level of the other axis.
  for (const auto& line : verdicts) CHECK(!line.starts_with("volume: "));
  CHECK(c.split.size() == 2 * 3 + 3);
  checkCorrectedByHolm(c.split);
  CHECK_THAT(textOf(describe(c)), ContainsSubstring("volume by a at each level of b"));
  CHECK(toJson(c)["split"].size() == 9);
}

TEST_CASE("Where what one axis does depends on another, levels with no difference are told together with a bound") {
  MadeStudy study;
  study.axes = {{"a", {"1", "2", "3"}}, {"b", {"x", "y", "z"}}};
  study.values = [](const std::vector<int>& l, int seed) {
    return Values{{"volume", 10 + (l[1] == 1 && l[0] == 2 ? 3 : 0) + noise(seed, 5) +
                                 0.1 * noise(seed, std::uint64_t(30 + 3 * l[0] + l[1]))}};
  };
  const auto verdicts = shownVerdicts(compared(study));
  CHECK_THAT(verdicts[0], ContainsSubstring(": with b y: 1 ") &&
                              ContainsSubstring(": 1 and 3, 2 and 3 differ; with b x, z: "
                                                "no difference is shown (95 % intervals within ±0."));
  CHECK_THAT(verdicts[1], ContainsSubstring("; with a 1, 2: no difference is shown"));
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
  const auto c = compared(policies(), {.margins = {"0.1"}});
  int sentences = 0;
  for (const auto& line : verdictsOf(c)) {
    if (!line.starts_with("clone_radius: ")) continue;
    ++sentences;
    if (line.find("tighter under longest") != line.npos)
      CHECK_THAT(line, ContainsSubstring("; a small difference, equivalent within ±0.1, 90 % interval "));
    else
      CHECK_THAT(line, ContainsSubstring("no difference is shown") && ContainsSubstring("; equivalent within ±0.1, "));
  }
  CHECK(sentences == 2);
}

TEST_CASE("Equivalent, different or not decided, by margins of a number, a share of the mean or a measure") {
  const auto verdictWith = [](const std::string& margin) {
    const auto c = compared(policies(), {.margins = {margin}});
    const auto& pair = pairOf(c, "clone_radius", "division");
    return pair.equivalence ? std::string(nameOf(pair.equivalence->verdict)) : "none";
  };
  CHECK(verdictWith("0.1") == "equivalent");
  CHECK(verdictWith("10%") == "equivalent");
  CHECK(verdictWith("clone-radius=10%") == "equivalent");
  CHECK(verdictWith("0.01") == "different");
  CHECK(verdictWith("1%") == "different");
  CHECK(verdictWith("0.047") == "not decided");
  CHECK(verdictWith("sister_contact=0.1") == "none");
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
  CHECK(json["verdicts"].size() == 6);
  const std::string csv = toCsv(c);
  CHECK(std::ranges::count(csv, '\n') == 1 + 80 + 8 + 4 + 2 * 3);  // title, values, conditions, pairs, effects
  CHECK(csv.starts_with(
      "kind,measure,axis:division,axis:connections,by,a,b,seed,time,n,distinct,unit,value,low,high,p,p_holm,"
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
