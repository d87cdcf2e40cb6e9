#pragma once
// The tables of a comparison. A column is declared once, with its names in `compare --json` and `--csv`, its title and
// its cell.
#include "analysis/study_comparison.h"
#include "document/table.h"

namespace morula {

/// The value of one run.
struct SeedValue {
  std::size_t measure, condition;
  std::uint64_t seed;
  double value;
};
Table valueTable(const StudyComparison& comparison);
Table conditionTable(const StudyComparison& comparison, const std::vector<ConditionSummary>& of);
Table pairTable(const StudyComparison& comparison, const std::vector<PairComparison>& of);
/// Makes the table of pairs that a margin was given for.
Table equivalenceTable(const StudyComparison& comparison, const std::vector<PairComparison>& of);
Table effectTable(const StudyComparison& comparison, const MeasureEffects& of);
Table courseTable(const StudyComparison& comparison, const TimeCourse& of);

/// Returns the label of each axis that is fixed.
Json labelsOf(const StudyResults& results, const std::vector<std::size_t>& levels);

}  // namespace morula
