// Comparisons of samples that are not normal: one path, skewed, two groups, one value, one run.
#include "made_comparisons.h"

using namespace morula;
using namespace morula::test;

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
