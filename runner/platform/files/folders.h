#pragma once
// Folders and names. The standard library's own functions throw what is no FileError, and some answer "no" where they
// could not look; these answer, or throw a FileError with the path and the reason.
#include <filesystem>
#include <string>
#include <vector>

namespace morula {

/// Returns true if the name leads to something, through links. Throws if that cannot be told: a folder on the way may
/// not be searched, a name is too long, links lead in circles.
bool fileExists(const std::filesystem::path& file);
bool isFolder(const std::filesystem::path& path);
/// A file itself, not a link to one.
bool isPlainFile(const std::filesystem::path& path);

/// [bytes]
std::uintmax_t fileSize(const std::filesystem::path& file);

/// Makes the folder and those above it; does nothing for "".
void makeFolder(const std::filesystem::path& folder);
/// Throws if there is anything already, unless it is an empty folder.
void requireAbsent(const std::filesystem::path& path);
/// Removes a file or a link. What is not there, or cannot be removed, is no error: false.
bool removeFile(const std::filesystem::path& file);

/// The names of the folder's files and folders, sorted.
std::vector<std::filesystem::path> namesIn(const std::filesystem::path& folder);
/// All files below the folder with this extension, as `folder`/…, sorted. Links to folders are not followed.
std::vector<std::filesystem::path> filesBelow(const std::filesystem::path& folder, const std::string& extension);

/// All files below the folder, as `folder`/…, sorted. Links to folders are followed, except those that lead back to a
/// folder on the way; links that lead nowhere, pipes and devices count as files.
std::vector<std::filesystem::path> everyFileBelow(const std::filesystem::path& folder);

std::filesystem::path currentFolder();
/// From the root, without "." and "..", links as they are.
std::filesystem::path absolutePath(const std::filesystem::path& path);
/// Returns true if `path` leads into the folder or below it, with all links followed. A path that is not there yet
/// counts by its folder.
bool liesWithin(const std::filesystem::path& path, const std::filesystem::path& folder);
/// Returns true if both are there and are one file, by whatever names.
bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b);
/// Returns the path to which a link leads.
std::filesystem::path readLink(const std::filesystem::path& link);

}  // namespace morula
