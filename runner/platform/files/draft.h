#pragma once
// A file that is written under a temporary name and takes its place when it is complete. A lock, which the system
// releases, tells drafts of dead processes from those still being written, on whatever machine.
#include <cstddef>
#include <filesystem>
#include <string_view>

#include "files/descriptor.h"

namespace morula {

class Draft {
 public:
  /// Makes an empty file in the folder of `file`, which must exist. Throws FileError that names `file`.
  explicit Draft(std::filesystem::path file);
  /// Removes the draft, unless it has taken its place.
  ~Draft();
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const std::filesystem::path& path() const { return draft_; }
  /// Appends bytes. Throws FileError.
  void write(std::string_view bytes);
  /// Writes the draft to the disk, then replaces `file` with it in one step. Throws FileError.
  void takePlace();

 private:
  std::filesystem::path file_, draft_;
  Descriptor descriptor_;
  bool placed_ = false;
};

/// Returns an unused name in the folder, which processes of several machines may share.
std::filesystem::path draftIn(const std::filesystem::path& folder);

/// Removes the drafts in the folder, files and folders [ScratchFolder], that no process holds any more. Returns their
/// number. Does nothing if the folder cannot be listed.
std::size_t removeAbandonedDrafts(const std::filesystem::path& folder);

/// Removes the drafts of this process, for an end without destructors.
void removeOwnDrafts();

}  // namespace morula
