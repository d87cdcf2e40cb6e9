#pragma once
// What the names on the command line lead to.
#include <string>
#include <vector>

namespace morula {

struct Sources {
  std::vector<std::string> databases, studies, checks, accuracies;  // files
};

/// What `what` names; the files of a folder sorted by name. Throws FileError for what is not there, UsageError for what is
/// nothing to report on.
Sources sourcesOf(const std::vector<std::string>& what);

}  // namespace morula
