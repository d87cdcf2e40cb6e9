#include "files/scratch_folder.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

#include "base/error.h"
#include "files/draft.h"
#include "files/folders.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

FileError cannotBeMade(const fs::path& folder) {
  return FileError("'" + folder.string() + "' cannot be made: " + std::strerror(errno));
}

/// Returns "a/b" for "a/b/" and "a/./b".
fs::path withoutSlash(const fs::path& folder) {
  const fs::path normal = folder.lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

/// Makes and returns the parent of `folder`, which must be absent or empty; the draft is made there.
fs::path parentFor(const fs::path& folder) {
  requireAbsent(folder);
  makeFolder(folder.parent_path());
  return folder.parent_path();
}

}  // namespace

ScratchFolder::ScratchFolder(const fs::path& parent) : lock_(-1) {
  removeAbandonedDrafts(parent.empty() ? fs::path(".") : parent);
  do {
    path_ = draftIn(parent);
    if (::mkdir(path_.c_str(), 0777) != 0) {
      if (errno == EEXIST) continue;  // used by a like-numbered process of another machine
      throw cannotBeMade(path_);
    }
    lock_ = Descriptor(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW));
    if (!lock_.isOpen() && errno != ENOENT) {
      const FileError error = cannotBeMade(path_);
      ::rmdir(path_.c_str());
      throw error;
    }
    if (lock_.isOpen()) ::flock(lock_.number(), LOCK_EX);
    // Until the folder is locked it looks abandoned, so another process may have removed it.
  } while (!lock_.isOpen() || !fileExists(path_));
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);  // links in the folder are removed, not followed
}

DraftFolder::DraftFolder(const fs::path& folder) : folder_(withoutSlash(folder)), scratch_(parentFor(folder_)) {}

void DraftFolder::takePlace() {
  const bool isThere = fileExists(folder_);
  const fs::path target = isThere ? fs::canonical(folder_) : folder_;
  // The working directory itself stays, since a shell in it would be left in a deleted folder.
  if (isThere && fs::equivalent(target, currentFolder())) {
    std::vector<fs::path> moved;
    for (const fs::path& name : namesIn(path())) {
      if (::rename((path() / name).c_str(), (target / name).c_str()) != 0) {
        const FileError error = cannotBeMade(folder_);
        for (const fs::path& back : moved) ::rename((target / back).c_str(), (path() / back).c_str());
        throw error;
      }
      moved.push_back(name);
    }
  } else if (::rename(path().c_str(), target.c_str()) != 0) throw cannotBeMade(folder_);
}

}  // namespace morula
