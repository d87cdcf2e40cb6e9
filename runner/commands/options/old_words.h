#pragma once
// Words of earlier command lines, which now have other names.
#include <string>
#include <vector>

namespace morula::cli {

/// Throws UsageError if `words`, those behind the program's name, use a former verb or option. The message names the
/// command that does the same now.
void checkOldWords(const std::vector<std::string>& words);

}  // namespace morula::cli
