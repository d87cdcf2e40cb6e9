#pragma once
// Checks the claims of a study file against its results, by the verdicts of a comparison.
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/study_results.h"
#include "study/study_file.h"

namespace morula {

struct ClaimFinding {
  std::string claim;  // "clone_radius: longest lower than x with base: free", "fill: 0.76 ± 0.01 under x"
  std::string found;  // the results' answer, a sentence of `study compare`
  bool holds = false;
  scenario::Place place;  // in the study file
};

/// Returns one finding for each claim, in their order. Pairs are those of compareStudy over all axes and measures, with
/// the other axes fixed where a claim fixes them. Equivalence is tested with the claim's margin for its measure alone.
/// A claim without values does not hold. Throws InputError if axes, labels or measures differ from the study's, and for
/// margins wider than the range of all values of their measure, each with its place.
std::vector<ClaimFinding> findClaims(const StudyResults& results, const Study& study);

/// Returns [{"claim", "holds", "found", "line"}, …].
Json claimsJson(const std::vector<ClaimFinding>& findings);

/// Returns true if the results have the axes, labels and measures of the study's claims.
bool canHold(const StudyResults& results, const Study& study);

/// Returns the study file as it was when this merged database was planned. Throws StoreError if it cannot be read.
Study plannedStudy(const std::filesystem::path& database);

}  // namespace morula
