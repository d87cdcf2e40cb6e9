#pragma once
// The places of goldens, and their acceptance.
#include <filesystem>
#include <string>

#include "golden/golden.h"

namespace morula {

struct Acceptance {
  std::string by;   // the name of the person who accepts
  std::string why;  // required: what changed and why the new result is right
};

/// Writes the golden, atomically, with the acceptance's name and reason; makes the folder if need be. Throws InputError
/// if the reason is missing, a rule matches nothing, or the environment variable CI is set and not empty, since people
/// accept goldens. Throws FileError if the file cannot be written.
void acceptGolden(const std::filesystem::path& file, Golden golden, const Acceptance& acceptance);
/// Throws InputError, beginning with `place`, unless name and reason are each one line of at most 1000 letters. Control
/// characters and characters that change the direction of a text are not allowed.
void requireAcceptable(const std::string& place, const Acceptance& acceptance);
/// Throws InputError if the environment variable CI is set; called before an acceptance starts runs.
void refuseWithinCi(const std::filesystem::path& file);

/// Returns "thesis/unique-four" for …/scenarios/thesis/unique-four.yaml: the path below the nearest folder `scenarios`,
/// or the file's stem elsewhere.
std::string goldenName(const std::filesystem::path& scenario);
/// Returns true for a scenario below a folder `scenarios`, whose name is its path from there.
bool liesInScenarios(const std::filesystem::path& scenario);
/// Returns …/golden/thesis/unique-four.golden for …/scenarios/thesis/unique-four.yaml; a scenario elsewhere has its
/// golden beside it.
std::filesystem::path goldenPath(const std::filesystem::path& scenario);
/// Returns …/golden for …/scenarios/thesis/unique-four.yaml; the scenario's own folder if no folder `scenarios` is
/// above it.
std::filesystem::path goldenFolder(const std::filesystem::path& scenario);

}  // namespace morula
