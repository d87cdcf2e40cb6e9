#pragma once
// The place of this program: its build folder, or an installation, in which nothing may be written.
#include <filesystem>
#include <optional>
#include <string>

namespace morula {

/// "explorer/explorer.js", which the program brings along beside itself or, installed, in share/morula; absent where it
/// was not built.
std::optional<std::filesystem::path> sharedFile(const std::string& name);

/// share/morula of the installation that the program belongs to; absent in a build folder.
std::optional<std::filesystem::path> installation();

/// Returns the words by which people start the program: the name by which its start script in the sources was called,
/// such as "./morula" (the script says so in MORULA_CALLED_AS), else "morula".
std::string programWord();

}  // namespace morula
