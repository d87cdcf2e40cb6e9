#pragma once
// The place of this program: its build folder, or an installation, in which it may not write.
#include <filesystem>
#include <optional>
#include <string>

namespace morula {

/// Returns the path of a file like "explorer/explorer.js", which lies beside the program or, installed, in
/// share/morula; absent if it was not built.
std::optional<std::filesystem::path> sharedFile(const std::string& name);

/// Returns share/morula of the program's installation; absent in a build folder.
std::optional<std::filesystem::path> installation();

/// Returns the name by which people start the program: that of its start script in the sources, such as "./morula"
/// (which the script gives in MORULA_CALLED_AS), else "morula".
std::string programWord();

}  // namespace morula
