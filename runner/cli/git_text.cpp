#include "cli/git_text.h"

#include "process/child_process.h"

namespace morula::cli {

std::optional<std::string> committedText(const std::filesystem::path& file) {
  const auto folder = std::filesystem::absolute(file).parent_path();
  ChildEnd git = runChild({"git", "-C", folder.string(), "show", "HEAD:./" + file.filename().string()},
                          {.silent = true});
  if (!git.well()) return std::nullopt;
  return std::move(git.said);
}

}  // namespace morula::cli
