#pragma once
// A file that is written under a name of its own and takes its place when it is whole. What a process that dies leaves
// behind is told from what another one is still writing, on whatever machine, by a lock that the system releases.
#include <cstddef>
#include <filesystem>
#include <string_view>

#include "files/descriptor.h"

namespace morula {

class Draft {
 public:
  /// An empty file in the folder of `file`, which must be there. Throws FileError that names `file`.
  explicit Draft(std::filesystem::path file);
  /// Removes it, unless it has taken its place.
  ~Draft();
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const std::filesystem::path& path() const { return draft_; }
  /// Adds to its end. Throws FileError.
  void write(std::string_view bytes);
  /// Once all of it is on the disk, it replaces what stands at `file`, in one step. Throws FileError.
  void takePlace();

 private:
  std::filesystem::path file_, draft_;
  Descriptor descriptor_;
  bool placed_ = false;
};

/// A name in the folder that nothing else uses. Processes of several machines may share the folder.
std::filesystem::path draftIn(const std::filesystem::path& folder);

/// Removes the drafts in the folder, files and folders [ScratchFolder], that no process holds any more. Returns how
/// many. Does nothing where folders cannot be listed.
std::size_t removeAbandonedDrafts(const std::filesystem::path& folder);

/// Removes the drafts of this process, for who ends it without destructors.
void removeOwnDrafts();

}  // namespace morula
