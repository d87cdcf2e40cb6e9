#pragma once
// compare --into-golden: what a scenario's settings change at its end goes into its golden file.
#include <filesystem>

#include "analysis/comparison.h"

namespace morula {

/// Replaces the lines `statistic` of the scenario's golden: of each measure the difference of the first level of the axis that is
/// compared, the scenario's own settings, from each other level. `study`: the merged database. Throws UsageError unless
/// exactly one axis is compared, InputError where the study is of another scenario, the golden is not of this very scenario
/// or may not be written, FileError if it cannot be.
void writeIntoGolden(const StudyComparison& comparison, const std::filesystem::path& study,
                     const std::filesystem::path& scenario);

}  // namespace morula
