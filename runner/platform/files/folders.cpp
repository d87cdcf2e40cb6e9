#include "files/folders.h"

#include <dirent.h>

#include <algorithm>
#include <cerrno>
#include <memory>

#include "base/error.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& path, const std::string& what, const std::error_code& error) {
  throw FileError("'" + path.string() + "' " + what + ": " + error.message());
}

fs::file_status statusOf(const fs::path& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  // If a file takes the place of a folder in the path, nothing is behind it.
  if (status.type() == fs::file_type::not_found) return status;
  if (error) refuse(path, "cannot be looked at", error);
  return status;
}

fs::path realPath(const fs::path& path) {
  std::error_code error;
  auto real = fs::weakly_canonical(path.empty() ? fs::path(".") : path, error);
  if (error) refuse(path, "cannot be looked at", error);
  return real.is_absolute() ? real : absolutePath(real);
}

/// Calls visit(name) for each entry. The iterators of std::filesystem end the program if memory runs out.
template <class Visit>
void eachEntry(const fs::path& folder, Visit visit) {
  const auto refuseNow = [&] { refuse(folder, "cannot be listed", {errno, std::generic_category()}); };
  const std::unique_ptr<DIR, int (*)(DIR*)> stream(::opendir(folder.c_str()), ::closedir);
  if (!stream) refuseNow();
  while (errno = 0, true) {
    const dirent* const entry = ::readdir(stream.get());
    if (!entry && errno) refuseNow();
    if (!entry) return;
    if (const std::string_view name = entry->d_name; name != "." && name != "..") visit(name);
  }
}

void addFilesBelow(const fs::path& folder, const std::string& extension, std::vector<fs::path>& files) {
  eachEntry(folder, [&](std::string_view name) {
    const fs::path file = folder / name;
    std::error_code ignored;
    if (fs::is_directory(fs::symlink_status(file, ignored))) addFilesBelow(file, extension, files);
    else if (file.extension() == extension && fs::is_regular_file(file, ignored)) files.push_back(file);
  });
}

/// Adds all files below the folder. `above`: the real paths of the folders on the way.
void addEveryFileBelow(const fs::path& folder, std::vector<fs::path>& above, std::vector<fs::path>& files) {
  above.push_back(realPath(folder));
  eachEntry(folder, [&](std::string_view name) {
    const fs::path file = folder / name;
    std::error_code ignored;
    if (!fs::is_directory(file, ignored)) files.push_back(file);
    else if (std::ranges::find(above, realPath(file)) == above.end()) addEveryFileBelow(file, above, files);
  });
  above.pop_back();
}

}  // namespace

bool fileExists(const fs::path& file) { return fs::exists(statusOf(file)); }

bool isFolder(const fs::path& path) { return fs::is_directory(statusOf(path)); }

bool isPlainFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(fs::symlink_status(path, ignored));
}

std::uintmax_t fileSize(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  if (error) refuse(file, "cannot be looked at", error);
  return size;
}

void makeFolder(const fs::path& folder) {
  if (folder.empty()) return;
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !isFolder(folder)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) refuse(folder, "cannot be made", error);
}

void requireAbsent(const fs::path& path) {
  if (fileExists(path) && !(isFolder(path) && namesIn(path).empty()))
    throw FileError("'" + path.string() + "' is there already; give another name, or an empty folder");
}

bool removeFile(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(fs::symlink_status(file, ignored))) return false;
  return fs::remove(file, ignored);
}

std::vector<fs::path> namesIn(const fs::path& folder) {
  std::vector<fs::path> names;
  eachEntry(folder, [&](std::string_view name) { names.emplace_back(name); });
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<fs::path> filesBelow(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  addFilesBelow(folder, extension, files);
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> everyFileBelow(const fs::path& folder) {
  std::vector<fs::path> above, files;
  addEveryFileBelow(folder, above, files);
  std::sort(files.begin(), files.end());
  return files;
}

fs::path currentFolder() {
  std::error_code error;
  auto folder = fs::current_path(error);
  if (error) refuse(".", "cannot be looked at", error);
  return folder;
}

fs::path absolutePath(const fs::path& path) {
  return (path.is_absolute() ? path : currentFolder() / path).lexically_normal();
}

bool liesWithin(const fs::path& path, const fs::path& folder) {
  const fs::path inner = realPath(path), outer = realPath(folder);
  const auto [rest, at] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  return rest == outer.end() || (rest->empty() && std::next(rest) == outer.end());
}

bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code none;
  return std::filesystem::equivalent(a, b, none);
}

fs::path readLink(const fs::path& link) {
  std::error_code error;
  auto target = fs::read_symlink(link, error);
  if (error) refuse(link, "cannot be read", error);
  return target;
}

}  // namespace morula
