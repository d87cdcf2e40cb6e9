#pragma once
// The parts of compareStudy, one file each.
#include "analysis/comparison.h"

namespace morula {

/// Fills `pairs`, correction and equivalence included.
void comparePairs(StudyComparison& comparison, bool within);
/// Fills `effects`.
void compareFactors(StudyComparison& comparison);
/// Fills `courses`.
void compareOverTime(StudyComparison& comparison);

/// The numbers of the axes with two levels or more that are compared.
std::vector<std::size_t> comparedAxes(const StudyComparison& comparison);

/// By statistics, or because both sides are known exactly.
bool isDifferent(const PairComparison& pair);
/// The sentence on a pair; where a margin was given, the one on its equivalence.
std::string pairInWords(const StudyComparison& comparison, const PairComparison& pair);

}  // namespace morula
