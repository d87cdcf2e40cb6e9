#pragma once
// A new folder for what is needed for a while; a folder that is there only when it is whole.
#include <filesystem>

#include "files/descriptor.h"

namespace morula {

/// Made with a name that nothing else has, and removed with all that it then holds, so that no file of the user's can
/// be in it. What a process that dies leaves behind, the next one in the same parent removes. Throws FileError.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::filesystem::path& parent);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Descriptor lock_;
};

/// Filled at path(), and then in its place in one step, so that a kill or a full disk leaves nothing under its name.
class DraftFolder {
 public:
  /// Throws FileError if there is anything at `folder` but an empty folder.
  explicit DraftFolder(const std::filesystem::path& folder);
  const std::filesystem::path& path() const { return scratch_.path(); }
  /// Throws FileError.
  void takePlace();

 private:
  std::filesystem::path folder_;
  ScratchFolder scratch_;
};

}  // namespace morula
