#include "system/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>

namespace morula {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_.isOpen()) flock(descriptor_.number(), LOCK_EX);
}

}  // namespace morula
