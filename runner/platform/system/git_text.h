#pragma once
// Earlier versions of a file, from git.
#include <filesystem>
#include <optional>
#include <string>

namespace morula {

/// Returns the file as last committed, or as in `commit`; nothing if there is no git, no repository or no such file in
/// it.
std::optional<std::string> committedText(const std::filesystem::path& file, const std::string& commit = "HEAD");

/// Returns the last commit that changed the file; nothing if there is none.
std::optional<std::string> lastCommitOf(const std::filesystem::path& file);

}  // namespace morula
