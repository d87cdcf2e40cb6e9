#pragma once
// What a scenario only names: its DNA and its mesh.
#include <filesystem>

#include "scenario/parameter.h"

namespace morula::scenario {

/// Where named files are looked for.
struct Places {
  std::filesystem::path folder;          // "": nowhere, only what is stored
  const std::vector<NamedFile>& stored;  // first, by role
  bool allowOutside;                     // of the folder
};

/// Parses the DNA and builds the mesh, from the scenario itself or from files. What is wrong in them is
/// reported with their own lines.
void readReferences(Scenario& scenario, Reading& reading, const Node& root, const Places& places);

}  // namespace morula::scenario
