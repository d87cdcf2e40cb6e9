#pragma once
// What a scenario only names: its DNA and its mesh.
#include <filesystem>

#include "scenario/parameter.h"

namespace morula {

/// All bytes of a file. Throws FileError.
std::string readFile(const std::filesystem::path& file);

namespace scenario {

/// Parses the DNA and builds the mesh, from the scenario itself or from files in `folder`. What is wrong in
/// them is reported with their own lines.
void readReferences(Scenario& scenario, Reading& reading, const Node& root,
                    const std::filesystem::path& folder);

}  // namespace scenario
}  // namespace morula
