#pragma once
// A scenario with nothing left to defaults.
#include "scenario/parameter.h"

namespace morula::scenario {

/// Every parameter of every part that exists, in the table's order. Itself a scenario: reading it gives the
/// same again.
Json resolve(const Scenario& scenario);

/// Every parameter that decides results, as `hashMeaning` takes them.
Json resolveMeaning(const Scenario& scenario);

/// The hash of all that decides results, the mesh's vertices among it.
Hash hashMeaning(const Scenario& scenario);

/// JSON with two spaces per level and numbers as std::to_chars writes them, the same on every machine.
std::string writeJson(const Json& value);

}  // namespace morula::scenario
