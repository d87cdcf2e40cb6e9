#pragma once
// What must be known first of the runs on a page: what failed, what is not sane, what is ambiguous, which seeds change nothing.
#include "report_data/words.h"

namespace morula {

/// Of one run.
std::vector<Finding> findingsOf(const RunFacts& run);

/// One sentence and the findings; of several runs also a table of them.
Document verdictOf(const std::vector<const RunFacts*>& runs);

}  // namespace morula
