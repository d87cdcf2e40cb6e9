#pragma once
// Folders and names. The standard library's functions throw other errors than FileError, and some answer "no" if they
// could not look. The functions of this file answer, or throw a FileError with the path and the reason.
#include <filesystem>
#include <string>
#include <vector>

namespace morula {

/// Returns true if the name leads to something, through links. Throws if that is unknown: a folder on the way may not
/// be searched, a name is too long, links lead in circles.
bool fileExists(const std::filesystem::path& file);
bool isFolder(const std::filesystem::path& path);
/// Returns true for a regular file itself, not for a link to one.
bool isPlainFile(const std::filesystem::path& path);

/// Returns the size of a file [bytes].
std::uintmax_t fileSize(const std::filesystem::path& file);

/// Makes the folder and its parents; does nothing for "".
void makeFolder(const std::filesystem::path& folder);
/// Throws if `path` exists, unless it is an empty folder.
void requireAbsent(const std::filesystem::path& path);
/// Removes a file or a link. Returns false, and throws nothing, if it does not exist or cannot be removed.
bool removeFile(const std::filesystem::path& file);

/// Returns the names of the folder's files and folders, sorted.
std::vector<std::filesystem::path> namesIn(const std::filesystem::path& folder);
/// Returns all files below the folder with this extension, as `folder`/…, sorted. Links to folders are not followed.
std::vector<std::filesystem::path> filesBelow(const std::filesystem::path& folder, const std::string& extension);

/// Returns all files below the folder, as `folder`/…, sorted. Links to folders are followed, except those to a folder
/// on the way. Links that lead nowhere, pipes and devices count as files.
std::vector<std::filesystem::path> everyFileBelow(const std::filesystem::path& folder);

std::filesystem::path currentFolder();
/// Returns the path from the root, without "." and ".."; links stay as they are.
std::filesystem::path absolutePath(const std::filesystem::path& path);
/// Returns true if `path` leads into the folder or below it, with all links followed. A path that does not exist counts
/// by its folder.
bool liesWithin(const std::filesystem::path& path, const std::filesystem::path& folder);
/// Returns true if both exist and are one file, by whatever names.
bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b);
/// Returns the path to which a link leads.
std::filesystem::path readLink(const std::filesystem::path& link);

}  // namespace morula
