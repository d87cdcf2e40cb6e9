#pragma once
// Reads a scenario that another program names by its file or gives as a text.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace morula {

/// Returns the changes of `--set` options and a seed. Throws InputError as parseOverride does.
std::vector<Override> overridesOf(const std::vector<std::string>& sets, std::optional<std::uint64_t> seed);

/// Reads a scenario file, or the scenario itself if `source` has more than one line; its files then lie in the working
/// directory. Throws InputError and FileError.
Scenario readSource(const std::string& source, const std::vector<Override>& overrides);

}  // namespace morula
