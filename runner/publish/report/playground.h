#pragma once
// The playground: a page in which scenarios are written, checked and run, without network and without this program.
#include <filesystem>
#include <string>

namespace morula {

/// Returns the page. `scenarios`: the folder of the scenarios it begins with; unreadable ones are left out. Throws
/// FileError if the page's program or its simulator is not built, or the folder has no scenario.
std::string playgroundPage(const std::filesystem::path& scenarios);

}  // namespace morula
