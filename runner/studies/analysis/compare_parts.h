#pragma once
// The parts of compareStudy, one file each.
#include <cmath>
#include <optional>
#include <span>

#include "analysis/study_comparison.h"

namespace morula {

/// The spread of values, as a share of the largest, below which runs count as one run: a millionth. Runs whose eggs
/// begin a millionth of a radius apart differ so little at their ends if nothing has made the difference grow.
inline constexpr double onePathSpread = 1e-6;
/// Returns true if the values differ by at most onePathSpread of the largest.
bool isOnePath(std::span<const double> values);
/// Fills `onePaths`: conditions with several final states of which most measures that vary at all vary so little. (A
/// rank correlation jumps where rounding breaks ties.)
void findOnePaths(StudyComparison& comparison);

/// The smallest and the largest value of a measure at the ends of all runs; low > high without values.
struct ValueRange {
  double low = INFINITY, high = -INFINITY;
};
ValueRange rangeOf(const StudyComparison& comparison, std::size_t measure);

/// Fills `pairs`, correction and equivalence included.
void comparePairs(StudyComparison& comparison, bool within);
/// Returns true if a margin is no narrower than a range that is not 0: then no two conditions could fail it.
bool isTooWide(const ValueRange& range, double margin);
/// Returns "±0.5 of sphericity is wider than the range of all its values (0.94 to 0.98), so any two conditions would
/// pass".
std::string tooWideText(const StudyComparison& comparison, std::size_t measure, double margin);
/// Returns "needs a margin below 0.04", the remedy.
std::string narrowerText(const StudyComparison& comparison, std::size_t measure);
/// Throws UsageError if a margin that is given for one measure is too wide for it.
void refuseWideMargins(const StudyComparison& comparison);
/// Fills `effects`.
void compareFactors(StudyComparison& comparison);
/// The strongest interaction of an axis with another that is shown for a measure, by its place among the effects.
/// Absent if none is shown. Needs the results of compareFactors.
struct Interaction {
  const MeasureEffects* of;
  std::size_t effect, other;  // other: axis
};
std::optional<Interaction> interactionOf(const StudyComparison& comparison, std::size_t measure, std::size_t axis);
/// Fills `split`. Needs the results of compareFactors.
void splitPairs(StudyComparison& comparison);
/// Fills `courses`.
void compareOverTime(StudyComparison& comparison);

/// Returns the numbers of the compared axes that have two levels or more.
std::vector<std::size_t> comparedAxes(const StudyComparison& comparison);

/// Appends sentences on what intervals assume: the shapes that samples show, and how often such intervals hold the
/// mean.
void addIntervals(const StudyComparison& comparison, std::vector<std::string>& verdicts);

/// Returns "0.62", or "below 0.001".
std::string shareText(double share);
/// Names the levels of `pairs` that differ: "every two" of several, or "1 and 3, 2 and 3"; "" if none is shown to.
std::string levelsThatDiffer(const StudyComparison& comparison, const std::vector<const PairComparison*>& pairs);
/// Returns [{"measure", "axis", "other", "eta_squared", …, "means": {level: {other level: mean}}, "levels_that_differ":
/// {other level: …}, "others_that_differ": {level: …}}, …]: the tables of interactionTables.
Json interactionsJson(const StudyComparison& comparison);

/// Returns true if two conditions differ, by statistics or because both sides are known exactly.
bool isDifferent(const PairComparison& pair);
/// Returns " with connections: none" for the axes whose level is fixed; "" if none is.
std::string withLevels(const StudyResults& results, const std::vector<std::optional<std::size_t>>& at);
/// Returns the sentence on a pair; if a margin was given, including the verdict on equivalence.
std::string pairInWords(const StudyComparison& comparison, const PairComparison& pair);

}  // namespace morula
