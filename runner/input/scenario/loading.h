#pragma once
// The steps of reading a file by the table, in their order.
#include <filesystem>
#include <string>
#include <vector>

#include "scenario/parameter_table.h"

namespace morula::scenario {

/// Fills the scenario from the document. Everything the table does not allow becomes a problem.
void readTable(const Node& root, Scenario& scenario, Reading& reading);

/// The places in which named files are looked for.
struct Places {
  std::filesystem::path folder;          // "": only stored files are known
  const std::vector<NamedFile>& stored;  // looked up first, by role
  bool allowOutside;                     // files may lie outside of the folder
};

/// Parses the DNA and builds the mesh, from the scenario itself or from files. Mistakes in files are reported with the
/// files' own lines.
void readReferences(Scenario& scenario, Reading& reading, const Node& root, const Places& places);

/// Sizes the shell by physics.shell.fill, and stretches the egg to an ellipsoid's shape (fitting_shell.cpp).
void fitShell(Scenario& scenario);

/// Checks values against each other, such as substances that the DNA lacks, or an egg that does not fit its shell.
void crossCheck(const Scenario& scenario, Reading& reading, const Node& root);

/// Returns the place of a parameter's value, or of the innermost map on its path that is given.
Place placeOf(const Node& root, const std::string& path);

/// Returns the parameter's value; null if it is not given.
const Node* given(const Node& root, const std::string& path);

/// Returns every parameter of every part that exists, in the table's order, as a scenario that reads the same.
Json resolve(const Scenario& scenario);

/// Returns every parameter that decides results, as `hashMeaning` takes them.
Json resolveMeaning(const Scenario& scenario);

/// Returns the hash of all that decides results, including the vertices of meshes.
Hash hashMeaning(const Scenario& scenario);

/// Adds the values of `check.reference`, if given.
void addReference(Hasher& hasher, const Scenario& scenario);

/// Writes JSON with two spaces a level and numbers as std::to_chars writes them, alike on every machine.
std::string writeJson(const Json& value);

}  // namespace morula::scenario
