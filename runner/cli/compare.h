#pragma once
// `morula compare` and `morula study compare` are the same.
#include "cli/verbs.h"

namespace morula::cli {

/// Adds the verb to the program or to `study`.
void addCompareTo(CLI::App& above, Action& action);

}  // namespace morula::cli
