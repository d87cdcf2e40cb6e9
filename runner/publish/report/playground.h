#pragma once
// The playground: one page in which scenarios are written, checked and run, without network and without this program.
#include <filesystem>
#include <string>

namespace morula {

/// `scenarios`: the folder of those to begin with; those that cannot be read are left out. Throws FileError where the
/// page's program or the simulator for it is not built, or no scenario is there.
std::string playgroundPage(const std::filesystem::path& scenarios);

}  // namespace morula
