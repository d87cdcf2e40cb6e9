// Main effects and interactions of studies with known values, and the tables that show them.
#include "analysis/compare_parts.h"
#include "made_comparisons.h"

using namespace morula;
using namespace morula::test;

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

TEST_CASE("A cell of an interaction's table names two pairs at most and counts more, where JSON names all") {
  MadeStudy study;
  study.axes = {{"a", {"1", "2", "3", "4"}}, {"b", {"x", "y"}}};
  study.values = [](const std::vector<int>& l, int seed) {
    return Values{{"volume", 10 + (l[1] == 1 && l[0] >= 2 ? l[0] : 0) + noise(seed, 5) +
                                 0.1 * noise(seed, std::uint64_t(30 + 2 * l[0] + l[1]))}};
  };
  const auto c = compared(study);
  const Json json = toJson(c);
  REQUIRE(json["interactions"].size() == 1);
  CHECK(json["interactions"][0]["levels_that_differ"]["y"] ==
        "1 and 3, 1 and 4, 2 and 3, 2 and 4, 3 and 4");  // 1 and 2 are the same
  const std::string tables = textOf(interactionTables(c));
  CHECK_THAT(tables, ContainsSubstring("5 of 6 pairs") && !ContainsSubstring("2 and 4"));
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
