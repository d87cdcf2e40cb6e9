#pragma once
// What must be known first of the runs on a page: what failed, what is not sane, what is ambiguous, which seeds change nothing.
#include "report_data/words.h"

namespace morula {

/// Of one run.
std::vector<Finding> findingsOf(const RunFacts& run);

/// HTML: one sentence and the findings; of several runs also a table of them.
std::string verdictOf(const std::vector<const RunFacts*>& runs);

}  // namespace morula
