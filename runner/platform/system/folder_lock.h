#pragma once
// One process at a time writes into a folder.
#include <filesystem>

namespace morula {

/// Waits until no other process holds the folder, and holds it to the end of the scope. The system releases it when a
/// process dies, and leaves no file behind. Where folders cannot be locked (some network disks) it does not wait.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;  // of the folder; -1: it could not be opened
};

}  // namespace morula
