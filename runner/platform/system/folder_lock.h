#pragma once
// A lock by which one process at a time writes into a folder.
#include <filesystem>

#include "files/descriptor.h"

namespace morula {

/// A lock on a folder to the end of the scope; the constructor waits for other processes. The system releases it when a
/// process dies, and leaves no file. Where folders cannot be locked (some network disks) it does not wait.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);

 private:
  Descriptor descriptor_;  // the folder, if it could be opened
};

}  // namespace morula
