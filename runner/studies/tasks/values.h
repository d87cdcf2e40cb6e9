#pragma once
// What a study keeps of a run: one number for each measure and time.
#include <map>
#include <string>
#include <vector>

#include "store/records.h"
#include "study_store/study_tables.h"

namespace morula {

/// The measures' values in each of the samples: a measure of the world as it is; of cells, the mean over the living cells
/// that have it; of pairs, the mean over the pairs that touch; of some cells alone where a measure says so. No row where there was
/// nothing to measure. `states`: the substances of each state in the samples. `measures`: names that findMeasure knows.
std::vector<ResultRow> valuesOf(const std::vector<Sample>& samples, const std::map<StateId, std::string>& states,
                                const std::vector<std::string>& measures);

}  // namespace morula
