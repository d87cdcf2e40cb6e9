#include "system/git_text.h"

#include "files/folders.h"
#include "system/child_process.h"

namespace morula {

std::optional<std::string> committedText(const std::filesystem::path& file) {
  const auto folder = absolutePath(file).parent_path();
  // Not `git show`: a repository of a stranger may name programs that it would start (text conversion, file system monitor,
  // remotes that fetch what is missing).
  ChildEnd git = runChild({"git", "-c", "core.fsmonitor=false", "-c", "protocol.allow=never", "-C",
                           folder.string(), "cat-file", "blob", "HEAD:./" + file.filename().string()},
                          {.silent = true});
  if (!git.well()) return std::nullopt;
  return std::move(git.said);
}

}  // namespace morula
