#include "system/installation.h"

#include <cstdlib>

#include "files/folders.h"
#include "files/text.h"
#include "system/child_process.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

fs::path ownFolder() { return fs::path(ownProgram()).parent_path(); }

}  // namespace

std::optional<fs::path> sharedFile(const std::string& name) {
  const auto installed = installation();
  const fs::path file = (installed ? *installed : ownFolder()) / name;
  return isPlainFile(file) ? std::optional(file) : std::nullopt;
}

std::optional<fs::path> installation() {
  const fs::path share = ownFolder().parent_path() / "share" / "morula";
  return isFolder(share) ? std::optional(share) : std::nullopt;
}

std::string programWord() {
  const char* called = std::getenv("MORULA_CALLED_AS");
  return called && *called && !installation() ? shellWord(called) : "morula";
}

}  // namespace morula
