#include "system/shared_files.h"

#include "files/folders.h"
#include "system/child_process.h"

namespace morula {

std::optional<std::filesystem::path> sharedFile(const std::string& name) {
  const auto own = std::filesystem::path(ownProgram()).parent_path();
  for (const auto& file : {own / name, own.parent_path() / "share" / "morula" / name})
    if (isPlainFile(file)) return file;
  return {};
}

}  // namespace morula
