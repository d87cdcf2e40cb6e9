#pragma once
// The steps of reading a file by the table, in their order.
#include <filesystem>
#include <string>
#include <vector>

#include "scenario/parameter_table.h"

namespace morula::scenario {

/// Fills the scenario from the document. Everything the table does not allow becomes a problem.
void readTable(const Node& root, Scenario& scenario, Reading& reading);

/// The places of named files.
struct Places {
  std::filesystem::path folder;          // "": nowhere, only what is stored
  const std::vector<NamedFile>& stored;  // first, by role
  bool allowOutside;                     // of the folder
};

/// Parses the DNA and builds the mesh, from the scenario itself or from files. What is wrong in them is
/// reported with their own lines.
void readReferences(Scenario& scenario, Reading& reading, const Node& root, const Places& places);

/// Sizes the shell by physics.shell.fill, and stretches the egg to an ellipsoid's shape (fitting_shell.cpp).
void fitShell(Scenario& scenario);

/// Substances that the DNA does not know, an egg that does not fit its shell, pictures without bodies.
void crossCheck(const Scenario& scenario, Reading& reading, const Node& root);

/// The place of a parameter's value, or of the innermost map that is given.
Place placeOf(const Node& root, const std::string& path);

/// The parameter's value, or else null.
const Node* given(const Node& root, const std::string& path);

/// Every parameter of every part that exists, in the table's order. Itself a scenario: reading it gives the same again.
Json resolve(const Scenario& scenario);

/// Every parameter that decides results, as `hashMeaning` takes them.
Json resolveMeaning(const Scenario& scenario);

/// The hash of all that decides results, the mesh's vertices among it.
Hash hashMeaning(const Scenario& scenario);

/// Adds what `check.reference` says, nothing without.
void addReference(Hasher& hasher, const Scenario& scenario);

/// JSON with two spaces per level and numbers as std::to_chars writes them, the same on every machine.
std::string writeJson(const Json& value);

}  // namespace morula::scenario
