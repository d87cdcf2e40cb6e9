#pragma once
// The values that decide a scenario's results, by keys, to list the differences of two scenarios.
#include <string>
#include <utility>
#include <vector>

namespace morula {

struct Scenario;

/// Returns path and value of everything that `Scenario::meaning` hashes, defaults filled in, in the table's order:
/// {"physics.pressure.constant", "155"}. Each value is one line. Long values (genes, many cells) are given by length
/// and hash. So is the content of a file: `physics.mesh.file.content` and `physics.shell.mesh.content`.
std::vector<std::pair<std::string, std::string>> decidingValues(const Scenario& scenario);

}  // namespace morula
