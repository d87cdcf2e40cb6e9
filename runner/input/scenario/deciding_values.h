#pragma once
// The values that decide a scenario's results, so that two scenarios can be told apart by names of keys.
#include <string>
#include <utility>
#include <vector>

namespace morula {

struct Scenario;

/// Path and value of everything that `Scenario::meaning` is a hash of, defaults filled in, in the table's order:
/// {"physics.pressure.constant", "155"}. Each value is one line. A long one (genes, many cells) is told by its length
/// and hash; of a mesh from a file so is the content, as `physics.mesh.file.content` (of a shell
/// `physics.shell.mesh.content`).
std::vector<std::pair<std::string, std::string>> decidingValues(const Scenario& scenario);

}  // namespace morula
