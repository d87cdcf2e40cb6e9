#pragma once
// Writes files; all other code uses these functions. A file is complete under a temporary name and on the disk before
// it takes its place. So a reader sees the old file or the new one, and a full disk costs neither. An existing file is
// replaced only if it is of the kind that the caller may replace: a mistyped -o must not cost a scenario or a database.
// A symbolic link is neither followed nor replaced. All functions throw FileError with the path and the reason.
#include <filesystem>
#include <string_view>

#include "files/content.h"

namespace morula {

/// Writes a file. It may replace only a file of content `kind`.
void writeFile(const std::filesystem::path& file, std::string_view bytes, Content kind);

/// Throws if `file` exists or has no folder; called before there are bytes to write.
void requireNewFile(const std::filesystem::path& file);

/// Writes a file that must not exist.
void writeNewFile(const std::filesystem::path& file, std::string_view bytes);

/// Writes a file. It may replace any regular file: for --force, and for files of this program alone.
void overwriteFile(const std::filesystem::path& file, std::string_view bytes);

/// Appends to a regular file, which is made if it does not exist.
void appendToFile(const std::filesystem::path& file, std::string_view bytes);

}  // namespace morula
