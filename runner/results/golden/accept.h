#pragma once
// The places of goldens, and their acceptance.
#include <filesystem>
#include <string>

#include "golden/golden.h"

namespace morula {

struct Acceptance {
  std::string by;   // who accepts
  std::string why;  // required: what changed and why the new result is right
};

/// Writes the golden, atomically, with the acceptance's name and reason; makes the folder if need be. Throws
/// InputError without a reason, with a rule that matches nothing, and when the environment variable CI is set
/// and not empty: goldens are accepted by people. Throws FileError if the file cannot be written.
void acceptGolden(const std::filesystem::path& file, Golden golden, const Acceptance& acceptance);
/// Throws InputError, beginning with `place`, unless name and reason are each one line of at most 1000 letters, without
/// control characters and characters that change the direction of a text.
void requireAcceptable(const std::string& place, const Acceptance& acceptance);
/// Throws InputError where goldens must not be written; asked before the runs that an acceptance takes.
void refuseWithinCi(const std::filesystem::path& file);

/// "thesis/unique-four" for …/scenarios/thesis/unique-four.yaml: the path below the nearest folder
/// `scenarios`, or the file's stem elsewhere.
std::string goldenName(const std::filesystem::path& scenario);
/// True for a scenario below a folder `scenarios`, whose name is its path from there.
bool liesInScenarios(const std::filesystem::path& scenario);
/// …/golden/thesis/unique-four.golden for …/scenarios/thesis/unique-four.yaml; unique-four.golden beside a
/// scenario that lies elsewhere.
std::filesystem::path goldenPath(const std::filesystem::path& scenario);
/// …/golden for …/scenarios/thesis/unique-four.yaml; the scenario's own folder where there is no folder `scenarios`
/// above it.
std::filesystem::path goldenFolder(const std::filesystem::path& scenario);

}  // namespace morula
