#pragma once
// One process at a time writes into a folder.
#include <filesystem>

#include "files/descriptor.h"

namespace morula {

/// Waits until no other process holds the folder, and holds it to the end of the scope. The system releases it when a
/// process dies, and leaves no file behind. Where folders cannot be locked (some network disks) it does not wait.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);

 private:
  Descriptor descriptor_;  // of the folder, if it could be opened
};

}  // namespace morula
