#pragma once
// What the program brings along beside itself: in its build folder, or where it was installed under share/morula.
#include <filesystem>
#include <optional>
#include <string>

namespace morula {

/// "explorer/explorer.js"; absent where it was not built.
std::optional<std::filesystem::path> sharedFile(const std::string& name);

}  // namespace morula
