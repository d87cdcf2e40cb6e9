#pragma once
// A temporary folder, and a folder that appears only when it is complete.
#include <filesystem>

#include "files/descriptor.h"

namespace morula {

/// A folder with an unused name, which is removed with its content; no file of the user's can be in it. A folder that a
/// dead process left is removed by the next process in the same parent. Throws FileError.
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

/// A folder filled at path() that takes its place in one step: a kill or a full disk leaves no part of it.
class DraftFolder {
 public:
  /// Throws FileError if `folder` exists and is not an empty folder.
  explicit DraftFolder(const std::filesystem::path& folder);
  const std::filesystem::path& path() const { return scratch_.path(); }
  /// Moves the folder to its place. Throws FileError.
  void takePlace();

 private:
  std::filesystem::path folder_;
  ScratchFolder scratch_;
};

}  // namespace morula
