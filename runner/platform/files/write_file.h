#pragma once
// The one way to write a file. It is whole under a name of its own and on the disk before it takes its place, so that a
// reader sees the old file or the new one, and a full disk costs neither. What stands at the place is replaced only if
// it is of the kind that the caller may replace: a mistyped -o must not cost a scenario or a database. A symbolic link
// is neither followed nor replaced. All functions throw FileError with the path and the reason.
#include <filesystem>
#include <string_view>

#include "files/content.h"

namespace morula {

/// Replaces a file that holds `kind` or nothing.
void writeFile(const std::filesystem::path& file, std::string_view bytes, Content kind);

/// Before there are bytes to write: throws if there is something at the place, or no folder to hold it.
void requireNewFile(const std::filesystem::path& file);

/// Replaces nothing.
void writeNewFile(const std::filesystem::path& file, std::string_view bytes);

/// Replaces any regular file: for --force, and for files that only this program makes in folders of its own.
void overwriteFile(const std::filesystem::path& file, std::string_view bytes);

/// Adds to the end of a regular file, which is made if it is not there.
void appendToFile(const std::filesystem::path& file, std::string_view bytes);

}  // namespace morula
