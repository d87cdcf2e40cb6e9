#pragma once
// One organism of each condition, side by side.
#include <filesystem>

#include "analysis/study_results.h"
#include "drawing/drawing.h"

namespace morula {

/// The final state of the first finished run of each condition, in the order of the conditions, the levels of the last axis
/// beside each other; all seen by one camera. Shapes are not stored, so each of these runs is computed again, with one
/// thread. A condition without a finished run has an empty tile. Throws UsageError if the runs have no bodies or are too many for
/// a picture, NondeterminismError if a run does not come to the state that the study has of it.
Drawing drawOrganisms(const StudyResults& results, const std::filesystem::path& study, bool quiet);

}  // namespace morula
