#pragma once
// Comparison of a study's results: every condition, every pair of levels, every factor.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/margins.h"
#include "analysis/study_results.h"
#include "document/document.h"
#include "statistics/equivalence.h"
#include "statistics/factorial.h"
#include "statistics/means.h"
#include "values/units.h"

namespace morula {

struct SmallMultiples;

struct CompareOptions {
  std::vector<std::string> by = {};        // axes whose levels are compared; none: all axes
  std::vector<std::string> measures = {};  // none: all
  std::vector<std::string> margins = {};   // texts for parseMargins; none: equivalence is not tested
  bool within = false;     // compare levels also at each level of the other axes, not only in their mean
  bool refuseWide = true;  // throw for a measure's own margin that is wider than the range of all its values
};

/// One measure under one condition, at the end of the runs.
struct ConditionSummary {
  std::size_t measure = 0, condition = 0;
  std::vector<std::uint64_t> seeds = {};  // with a value
  std::vector<double> values = {};        // one for each of `seeds`
  std::size_t distinct = 0;               // number of different final states
  double mean = 0;                        // of the distinct runs: a run of several seeds counts once. 0 without values
  /// 95 % interval of the mean; absent for one value, and where seeds change nothing or all runs are one path.
  std::optional<Interval> interval = {};
  SampleShape shape = SampleShape::plain;  // of the values of the distinct runs
  bool onePath = false;                    // the condition is one path, and the values differ as little
};

/// How well a difference is known.
enum class Known { estimated, exact, onePath, oneSeed };
template <>
inline constexpr auto choices<Known> = std::to_array<Choice<Known>>(
    {{Known::estimated, "estimated", "two pairs of runs or more: the difference has an interval"},
     {Known::exact, "exact", "seeds change neither side: the difference is exact"},
     {Known::onePath, "one path",
      "the runs of all seeds are one run but for rounding: the difference is known as well"},
     {Known::oneSeed, "one seed", "one pair of runs alone: the variation is not known"}});

/// The test that two conditions are equal within a margin. A margin wider than the range of all values of all
/// conditions is not tested: no two conditions could fail it.
struct PairEquivalence {
  Equivalence test;
  double corrected = 1, correctedBeyond = 1;  // Holm
  Equivalent verdict = Equivalent::undecided;
};

/// Two levels of one axis. Each pair of values is of one seed: the mean over the conditions with level a, and over
/// those with level b that differ in nothing else. Conditions count if both have been measured.
struct PairComparison {
  std::size_t measure = 0, axis = 0, a = 0, b = 0;  // levels of the axis, a < b
  std::vector<std::optional<std::size_t>> at;       // [axis] the level if it is fixed; absent: the mean over all levels
  Known known = Known::estimated;
  bool sameRuns = false;            // both levels mean the same scenes
  std::size_t seeds = 0;            // number of seeds for which both sides have values
  std::vector<double> of, against;  // [pair] values of a and of b; pairs of the same runs count once
  double meanA = 0, meanB = 0;
  MeanDifference paired;                   // with n ≥ 2; else the difference alone
  std::optional<MeanDifference> unpaired;  // the values of both sides without their pairing
  EffectSizes effect{};
  Signs signs{};
  std::optional<double> corrected;  // p of `paired`, by Holm over all tested pairs; absent without a test
  std::optional<PairEquivalence> equivalence;

  bool isOfMean() const;  // no other axis is fixed
  bool isShown() const { return known == Known::estimated && corrected.value_or(1) < 0.05; }
  /// Returns the width of the paired interval over the unpaired one's, both Student's: below 1 common random numbers
  /// pay. Absent where nothing varies.
  std::optional<double> intervalRatio() const;
};

/// Main effects and interactions of the compared axes, in the mean over all other axes; seeds are blocks.
struct MeasureEffects {
  std::size_t measure = 0;
  std::vector<std::size_t> axes = {};           // axes with two levels or more; factors are numbered by this list
  std::vector<std::vector<double>> means = {};  // [place in `axes`][level]
  FactorialAnalysis analysis = {};
  std::vector<std::optional<double>> corrected = {};  // [effect] its p by Holm over all effects of all measures
  std::string untested = {};                          // why there is no F test; "" if there is one
  std::size_t seeds = 0;
};

/// One measure under one condition, over time.
struct TimeCourse {
  std::size_t measure = 0, condition = 0;
  struct Point {
    double time = 0;
    std::size_t n = 0;  // distinct runs
    double mean = 0;
    std::optional<Interval> interval;  // as ConditionSummary::interval
  };
  std::vector<Point> points = {};
};

struct StudyComparison {
  StudyResults results;
  std::vector<std::size_t> by;        // axes, in the order asked for
  std::vector<std::size_t> measures;  // the measures that are compared
  std::vector<Margin> margins;
  std::vector<std::size_t> seedless;         // conditions whose seeds change nothing, in a study with several seeds
  std::vector<std::size_t> onePaths;         // conditions whose runs are one run but for rounding (one_path.cpp)
  std::vector<ConditionSummary> conditions;  // by measure, then condition
  std::vector<PairComparison> pairs;         // by measure, axis, fixed levels, levels
  std::vector<MeasureEffects> effects;
  /// Pairs of axes that interact with another axis: their levels at each level of that axis. For Holm they are a family
  /// of their own.
  std::vector<PairComparison> split;
  std::vector<TimeCourse> courses;  // courses of measures that were taken at several times
  Units units = {};                 // of its numbers; without names: the scene's own

  const std::string& measureName(std::size_t m) const { return results.measures[m]; }
};

/// Throws UsageError for axes, measures and margins that the study does not have, and for margins too wide to test.
StudyComparison compareStudy(StudyResults results, const CompareOptions& options);

/// Returns a comparison with its numbers, which are in the scene's own units, in those that people know.
StudyComparison inUnits(StudyComparison comparison, const Units& units);
/// Returns the sentence that names the known units of its numbers; "" for the scene's own.
std::string unitsInWords(const StudyComparison& comparison);
/// Returns {"clone_radius": {"unit": "length", "known_unit": {"name": "µm", "factor": 27}}, …} for measures and time.
Json unitsJson(const StudyComparison& comparison, const Units& known);

/// Returns sentences. First, for each axis and measure: whether the axis matters, how much and between which levels; at
/// each level of another axis if the two interact. Then, by measure and pair, what differs, what is equivalent and what
/// tells nothing. Last, where no difference is shown.
std::vector<std::string> verdictsOf(const StudyComparison& comparison);
/// Returns lines on runs that failed, are missing or are not sane, and on groups of conditions with the same runs.
std::vector<std::string> troublesOf(const StudyResults& results);

/// Returns a table for each two axes that interact: the means at all their levels, and which of them differ.
Document interactionTables(const StudyComparison& comparison);
/// Returns the table of the measures: key, name, unit and meaning.
Table measureTable(const StudyComparison& comparison);
/// Describe a comparison for people: as a whole, and its tables alone.
Document describe(const StudyComparison& comparison);
Document comparedTables(const StudyComparison& comparison);
/// Writes a comparison for `compare --json`. `known`: the units that people know; the numbers stay the scene's.
Json toJson(const StudyComparison& comparison, const Units& known = {});
/// Returns one table of rows of several kinds (value, condition, pair, effect, course), named in the first column.
/// Fields are quoted as RFC 4180 says; lines end in a line feed.
std::string toCsv(const StudyComparison& comparison);

/// Draws a panel for each measure: all values of each condition, their mean and its interval. Further panels show the
/// means over time, if there are time courses. The first compared axis is shown by colour and shape, other axes by
/// words. `units`: units of the numbers.
SmallMultiples stripsOf(const StudyComparison& comparison, const Units& units = {});

/// Replaces the lines `statistic` of the scenarios' goldens: for each measure the difference between the first level of
/// the compared axis, the scenario's own settings, and each other level. `study`: the merged database with `results`.
/// In a study of several bases, only runs of a scenario count for its golden. Throws UsageError unless exactly one axis
/// besides `base` is compared. Throws InputError before any file is written if the study is of another scenario, or a
/// golden is not of this very scenario or must not be written; FileError if writing fails.
void writeIntoGoldens(const StudyResults& results, CompareOptions options, const std::filesystem::path& study,
                      const std::vector<std::string>& scenarios);

/// Returns all conditions, by difference: the two whose means are farthest apart, then each condition that is farthest
/// from all before it [Gonzalez 1985]. The distance is the root of the sum of squared differences over the measures, in
/// standard deviations of all values. The earlier of equals comes first, conditions without values last.
std::vector<std::size_t> byDifference(const StudyComparison& comparison);

}  // namespace morula
