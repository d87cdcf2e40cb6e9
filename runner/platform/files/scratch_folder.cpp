#include "files/scratch_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>

#include "base/error.h"

namespace morula {

ScratchFolder::ScratchFolder(const std::filesystem::path& parent) {
  std::string name = (parent / ".morula-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw FileError("'" + name + "' cannot be made: " + std::strerror(errno));
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);  // links in it are removed, not followed
}

}  // namespace morula
