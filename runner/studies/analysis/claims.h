#pragma once
// The claims of a study file held against its results, by what a comparison says.
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/study_results.h"
#include "study/study_file.h"

namespace morula {

struct ClaimFinding {
  std::string claim;  // "clone_radius: longest lower than x with base: free", "fill: 0.76 ± 0.01 under x"
  std::string found;  // what the results say, a sentence of `study compare`
  bool holds = false;
  scenario::Place place;  // in the study file
};

/// One finding for each claim, in their order. Pairs are those of compareStudy over all axes and measures, with the
/// other axes fixed where a claim fixes them; equivalence is tested with the claim's margin for its measure alone. What
/// has no values holds nothing. Throws InputError if the results are of other axes, labels or measures than the study.
std::vector<ClaimFinding> findClaims(const StudyResults& results, const Study& study);

/// True if the results have the axes, labels and measures of the study's claims.
bool canHold(const StudyResults& results, const Study& study);

/// The study file as it was when this merged database was planned. Throws StoreError if it cannot be read.
Study plannedStudy(const std::filesystem::path& database);

}  // namespace morula
