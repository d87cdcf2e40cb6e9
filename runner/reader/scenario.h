#pragma once
// The reader of scenarios for other programs: a scenario as people write it in, the scene for morula::Simulator out
// (morula.h). CMake's target is Morula::scenarios.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace morula {

struct ReadScenario {
  std::string scene;                  // the text that Simulator takes
  std::vector<std::string> warnings;  // on what works but may not be meant: "file:line:column: path: …"
};

/// Reads a scenario file, or the scenario itself if `source` has more than one line; files that such a text names lie
/// in the working directory. `sets`: changes as `--set` of the program takes them, "physics.drag=5". Throws InputError
/// with one line per mistake, and FileError if a file cannot be read (base/error.h).
ReadScenario readScenario(const std::string& source, const std::vector<std::string>& sets = {},
                          std::optional<std::uint64_t> seed = {});

}  // namespace morula
