#pragma once
// A plan in the folder of its study.
#include <filesystem>

#include "study/plan.h"

namespace morula {

/// FOLDER/plan.json.
std::filesystem::path planFile(const std::filesystem::path& folder);

/// Writes the plan into the folder, which is made; false if the same plan is there already, which stays as it is. Throws
/// InputError if another plan is there: what was computed by it would be taken for this one's. Throws FileError.
bool keepPlan(const Plan& plan, const std::filesystem::path& folder);

/// The plan of the folder. Throws FileError as readPlan, and if there is none.
Plan loadPlan(const std::filesystem::path& folder);

}  // namespace morula
