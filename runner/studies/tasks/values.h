#pragma once
// What a study keeps of a run: one number for each measure and time.
#include <string>
#include <vector>

#include "store/records.h"
#include "study_store/study_tables.h"

namespace morula {

/// The measures' values in each of the samples: a measure of the world as it is; of cells, the mean over the living cells
/// that have it; of pairs, the mean over the pairs that touch. No row where there was nothing to measure.
/// `measures`: names of studyMeasures().
std::vector<ResultRow> valuesOf(const std::vector<Sample>& samples, const std::vector<std::string>& measures);

}  // namespace morula
