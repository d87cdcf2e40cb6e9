#include "system/git_text.h"

#include "files/folders.h"
#include "system/child_process.h"

namespace morula {
namespace {

/// Asks git by plumbing commands and not by `git show` or `git log`. In a stranger's repository these could start
/// programs that it names (text conversion, file system monitor, signatures, remotes that fetch missing objects).
ChildEnd askGit(const std::filesystem::path& file, const std::vector<std::string>& question) {
  const std::string folder = absolutePath(file).parent_path().string();
  std::vector<std::string> command{"git", "-c", "core.fsmonitor=false", "-c", "protocol.allow=never", "-C", folder};
  command.insert(command.end(), question.begin(), question.end());
  return runChild(command, {.silent = true});
}

}  // namespace

std::optional<std::string> committedText(const std::filesystem::path& file, const std::string& commit) {
  ChildEnd git = askGit(file, {"cat-file", "blob", commit + ":./" + file.filename().string()});
  if (!git.well()) return std::nullopt;
  return std::move(git.said);
}

std::optional<std::string> lastCommitOf(const std::filesystem::path& file) {
  ChildEnd git = askGit(file, {"rev-list", "-1", "HEAD", "--", file.filename().string()});
  if (!git.well() || git.said.empty()) return std::nullopt;
  return git.said.substr(0, git.said.find('\n'));
}

}  // namespace morula
