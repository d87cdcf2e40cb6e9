// Sentences of comparisons of known values: what differs, what is equivalent, by which margin.
#include "made_comparisons.h"
#include "statistics/equivalence.h"
#include "system/usage_error.h"

using namespace morula;
using namespace morula::test;

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
