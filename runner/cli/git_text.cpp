#include "cli/git_text.h"

#include "explain/child.h"

namespace morula::cli {

std::optional<std::string> committedText(const std::filesystem::path& file) {
  const auto folder = std::filesystem::absolute(file).parent_path();
  auto answer = ask({"git", "-C", folder.string(), "show", "HEAD:./" + file.filename().string()}, true);
  if (!answer || answer->exitCode != 0) return std::nullopt;
  return std::move(answer->output);
}

}  // namespace morula::cli
