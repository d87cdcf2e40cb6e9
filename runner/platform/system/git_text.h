#pragma once
// Earlier versions of a file, from git.
#include <filesystem>
#include <optional>
#include <string>

namespace morula {

/// The file as it was last committed, or as it was in `commit`; nothing where there is no git, no repository or no such
/// file in it.
std::optional<std::string> committedText(const std::filesystem::path& file, const std::string& commit = "HEAD");

/// The last commit that changed the file; nothing where there is none.
std::optional<std::string> lastCommitOf(const std::filesystem::path& file);

}  // namespace morula
