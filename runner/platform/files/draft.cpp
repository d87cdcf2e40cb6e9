#include "files/draft.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/folders.h"

namespace morula {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view beginning = ".morula-", ending = ".part";

[[noreturn]] void refuse(const fs::path& file) {
  throw FileError("'" + file.string() + "' cannot be written: " + std::strerror(errno));
}

/// The folders in which this process has made drafts.
std::mutex knownMutex;
std::set<fs::path> known;

/// Returns true on this process's first call for the folder. Each folder is searched once for drafts of dead processes.
bool isNewHere(const fs::path& folder) {
  const std::lock_guard lock(knownMutex);
  return known.insert(folder).second;
}

/// Returns the beginning of the names of this process's drafts.
std::string ownBeginning() {
  char host[65] = {};
  ::gethostname(host, sizeof host - 1);
  for (char& c : host)
    if (c == '/') c = '_';
  return std::string(beginning) + host + "-" + std::to_string(::getpid()) + "-";
}

/// Returns true if the draft exists: until it was locked, another process may have removed it as abandoned.
bool isThere(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

}  // namespace

Draft::Draft(fs::path file) : file_(std::move(file)), descriptor_(-1) {
  if (const fs::path folder = file_.has_parent_path() ? file_.parent_path() : "."; isNewHere(folder))
    removeAbandonedDrafts(folder);
  do {
    draft_ = draftIn(file_.parent_path());
    descriptor_ = Descriptor(::open(draft_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666));
    if (!descriptor_.isOpen() && errno == EEXIST) continue;  // used by a like-numbered process of another machine
    if (!descriptor_.isOpen()) refuse(file_);
    ::flock(descriptor_.number(), LOCK_EX);
  } while (!descriptor_.isOpen() || !isThere(descriptor_.number()));
}

Draft::~Draft() {
  if (!placed_) ::unlink(draft_.c_str());
}

void Draft::write(std::string_view bytes) {
  if (!writeAll(descriptor_.number(), bytes)) refuse(file_);
}

void Draft::takePlace() {
  if (::fsync(descriptor_.number()) != 0 || ::rename(draft_.c_str(), file_.c_str()) != 0) refuse(file_);
  placed_ = true;
  if (!descriptor_.close()) refuse(file_);
}

fs::path draftIn(const fs::path& folder) {
  static std::atomic<unsigned> number{0};
  return folder / (ownBeginning() + std::to_string(++number) + std::string(ending));
}

void removeOwnDrafts() {
  const std::unique_lock lock(knownMutex, std::try_to_lock);
  if (!lock) return;
  const std::string own = ownBeginning();
  for (const fs::path& folder : known)
    for (const fs::path& name : namesIn(folder.empty() ? fs::path(".") : folder)) {
      std::error_code ignored;
      if (name.string().starts_with(own)) fs::remove_all(folder / name, ignored);
    }
}

std::size_t removeAbandonedDrafts(const fs::path& folder) {
  std::size_t removed = 0;
  isNewHere(folder);
  std::vector<fs::path> names;
  try {
    if (isFolder(folder)) names = namesIn(folder);
  } catch (const FileError&) { return removed; }
  for (const fs::path& name : names) {
    const std::string text = name.string();
    if (!text.starts_with(beginning) || !text.ends_with(ending)) continue;
    const fs::path file = folder / name;
    const Descriptor held(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    if (!held.isOpen() || ::flock(held.number(), LOCK_EX | LOCK_NB) != 0) continue;
    std::error_code ignored;
    if (fs::remove_all(file, ignored) > 0) ++removed;  // links in the folder are removed, not followed
  }
  return removed;
}

}  // namespace morula
