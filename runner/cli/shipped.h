#pragma once
// The scenarios of a source tree.
#include <string>
#include <vector>

namespace morula::cli {

/// All scenarios/…/*.yaml below the working folder, sorted. Throws FileError if there is no folder
/// `scenarios`.
std::vector<std::string> shippedScenarios();

}  // namespace morula::cli
