#pragma once
// A study's results held against each other: every condition, every pair of levels, every factor.
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
  std::vector<std::string> by = {};        // axes whose levels are held against each other; none: all axes
  std::vector<std::string> measures = {};  // none: all
  std::vector<std::string> margins = {};   // as parseMargins takes them; none: equivalence is not tested
  bool within = false;  // hold levels against each other also at each level of the other axes, not only in their mean
};

/// One measure under one condition, at the end of the runs.
struct ConditionSummary {
  std::size_t measure = 0, condition = 0;
  std::vector<std::uint64_t> seeds = {};  // those with a value
  std::vector<double> values = {};        // one for each of them
  std::size_t distinct = 0;               // final states that differ
  double mean = 0;                        // of the distinct runs: what was computed once counts once. 0 without values
  /// Student's 95 % interval of the mean; none if seeds change nothing, or for one value.
  std::optional<Interval> interval = {};
};

/// How a difference is known.
enum class Known { estimated, exact, oneSeed };
template <>
inline constexpr auto choices<Known> = std::to_array<Choice<Known>>(
    {{Known::estimated, "estimated", "two pairs or more: with an interval"},
     {Known::exact, "exact", "seeds change neither side: the difference is what it is"},
     {Known::oneSeed, "one seed", "one pair of runs alone: nothing says how far it would vary"}});

/// The test that two conditions are alike within a margin.
struct PairEquivalence {
  Equivalence test;
  double corrected = 1, correctedBeyond = 1;  // Holm
  Equivalent verdict = Equivalent::undecided;
};

/// Two levels of one axis. Each pair is of one seed: the mean over the conditions with level a and over those with
/// level b that differ in nothing else and have both been measured.
struct PairComparison {
  std::size_t measure = 0, axis = 0, a = 0, b = 0;  // levels of the axis, a < b
  std::vector<std::optional<std::size_t>> at;       // [axis] its level if it is fixed; otherwise the mean over it
  Known known = Known::estimated;
  bool sameRuns = false;            // both levels mean the same scenes
  std::size_t seeds = 0;            // for which both sides have values
  std::vector<double> of, against;  // [pair] of a and of b; pairs of the same runs count once
  double meanA = 0, meanB = 0;
  MeanDifference paired;                   // n ≥ 2: otherwise the difference alone
  std::optional<MeanDifference> unpaired;  // the same values without their pairs
  EffectSizes effect{};
  Signs signs{};
  std::optional<double> corrected;  // p of `paired`, by Holm over all pairs that are tested; absent where none is
  std::optional<PairEquivalence> equivalence;

  bool isOfMean() const;  // over all other axes: none is fixed
  bool isShown() const { return known == Known::estimated && corrected.value_or(1) < 0.05; }
  /// Width of the paired interval over the unpaired one's: below 1 common random numbers pay. None where nothing
  /// varies.
  std::optional<double> intervalRatio() const;
};

/// Main effects and interactions of the axes that are compared, in the mean over the others; seeds are blocks.
struct MeasureEffects {
  std::size_t measure = 0;
  std::vector<std::size_t> axes = {};           // with two levels or more; factors count in these
  std::vector<std::vector<double>> means = {};  // [axis of these][level]
  FactorialAnalysis analysis = {};
  std::vector<std::optional<double>> corrected = {};  // [effect] its p by Holm over all effects of all measures
  std::string untested = {};                          // why there is no F test; "": there is one
  std::size_t seeds = 0;
};

/// One measure under one condition, over time.
struct TimeCourse {
  std::size_t measure = 0, condition = 0;
  struct Point {
    double time = 0;
    std::size_t n = 0;  // distinct runs
    double mean = 0;
    std::optional<Interval> interval;  // as ConditionSummary
  };
  std::vector<Point> points = {};
};

struct StudyComparison {
  StudyResults results;
  std::vector<std::size_t> by;        // axes, in the order asked for
  std::vector<std::size_t> measures;  // those compared
  std::vector<Margin> margins;
  std::vector<std::size_t> seedless;         // conditions whose seeds change nothing, though the study has several
  std::vector<ConditionSummary> conditions;  // by measure, then condition
  std::vector<PairComparison> pairs;         // by measure, axis, what is fixed, levels
  std::vector<MeasureEffects> effects;
  /// Pairs of axes that interact with another one: their levels at each level of that axis; a family of their own for
  /// Holm.
  std::vector<PairComparison> split;
  std::vector<TimeCourse> courses;  // of measures that were taken at several times

  const std::string& measureName(std::size_t m) const { return results.measures[m]; }
};

/// Throws UsageError for axes, measures and margins that the study has not.
StudyComparison compareStudy(StudyResults results, const CompareOptions& options);

/// Sentences: first whether each axis matters to each measure, how much and between which levels, at each level of
/// another axis where the two interact; then what differs, what is equivalent and what tells nothing, then where no
/// difference is shown; these by measure and pair.
std::vector<std::string> verdictsOf(const StudyComparison& comparison);
/// Runs that failed, are missing or are not sane, a line each; and groups of conditions that are the same runs.
std::vector<std::string> troublesOf(const StudyResults& results);

/// Describe a comparison for people: as a whole, and the tables alone.
Document describe(const StudyComparison& comparison);
Document comparedTables(const StudyComparison& comparison);
/// Writes a comparison for `compare --json`.
Json toJson(const StudyComparison& comparison);
/// One table: rows of several kinds (value, condition, pair, effect, course), named in the first column. Quoted as RFC
/// 4180 says; lines end in a line feed.
std::string toCsv(const StudyComparison& comparison);

/// A panel a measure: all values of each condition, their mean and its interval; then, where there are time courses, a
/// panel a measure of the means over time. The first axis that is compared is told by colour and shape, the others by
/// words. `units`: in which numbers are shown.
SmallMultiples stripsOf(const StudyComparison& comparison, const Units& units = {});

/// Replaces the lines `statistic` of the scenarios' goldens: of each measure the difference of the first level of the
/// axis that is compared, the scenario's own settings, from each other level. `study`: the merged database, and
/// `results` what it holds; of a study with several bases only the runs of a scenario count for its golden. Throws
/// UsageError unless exactly one axis besides `base` is compared, InputError where the study is of another scenario, a
/// golden is not of this very scenario or may not be written, and has written none then; FileError if one cannot be.
void writeIntoGoldens(const StudyResults& results, CompareOptions options, const std::filesystem::path& study,
                      const std::vector<std::string>& scenarios);

/// All conditions, those that differ most first: the two whose means are farthest apart, then each that is farthest
/// from all before it [Gonzalez 1985]. Far: the root of the sum of squared differences over the measures, each in
/// standard deviations of all its values. Among equals the earlier one; conditions without any value come last.
std::vector<std::size_t> byDifference(const StudyComparison& comparison);

}  // namespace morula
