#pragma once
// The parts of compareStudy, one file each.
#include <optional>

#include "analysis/study_comparison.h"

namespace morula {

/// Fills `pairs`, correction and equivalence included.
void comparePairs(StudyComparison& comparison, bool within);
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

/// Returns true if two conditions differ, by statistics or because both sides are known exactly.
bool isDifferent(const PairComparison& pair);
/// Returns " with connections: none" for the axes whose level is fixed; "" if none is.
std::string withLevels(const StudyResults& results, const std::vector<std::optional<std::size_t>>& at);
/// Returns the sentence on a pair; if a margin was given, including the verdict on equivalence.
std::string pairInWords(const StudyComparison& comparison, const PairComparison& pair);

}  // namespace morula
