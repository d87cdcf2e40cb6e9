#pragma once
// The sources and tools of this program, fixed when it was built (build_info.cmake writes the values).
#include <string>
#include <utility>
#include <vector>

namespace morula {

struct BuildInfo {
  std::string version;  // "0.1.0"
  // Digest of all sources and build files of core/, reports/ and runner/. It needs no git and sees uncommitted edits
  std::string sources;
  std::string gitCommit;  // "unknown" without git, as in a source archive
  std::string gitState;   // "clean", "modified" (tracked files differ from the commit) or "unknown"
  std::string compiler;   // "GNU 12.2.0"
  std::string flags;      // build type and compiler options
  std::string target;     // "Linux x86_64"
  std::vector<std::pair<std::string, std::string>> libraries;  // name and version, sorted by name
};

const BuildInfo& buildInfo();

/// Returns the difference of the sources from their commit, by `git diff`; "" for a clean tree. A text over 256 KiB is
/// cut, which its last line says.
const std::string& buildDiff();

/// Returns "Eigen 3.4.0; SQLite 3.40.1"; librariesFrom reads such a text.
std::string librariesText(const BuildInfo& build);
std::vector<std::pair<std::string, std::string>> librariesFrom(const std::string& text);

/// Returns 32 hexadecimal digits over what can change a result: sources, compiler, flags, target, libraries. The commit
/// is left out, since the same sources under another commit are the same program.
std::string buildId(const BuildInfo& build);

}  // namespace morula
