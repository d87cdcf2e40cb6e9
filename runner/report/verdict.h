#pragma once
// What must be known first of the runs on a page: what failed, what is not sane, what is ambiguous, which seeds change nothing.
#include "report/words.h"

namespace morula {

/// Of one run.
std::vector<Finding> findingsOf(const RunFacts& run);

/// HTML: one sentence and the findings; of several runs also a table of them.
std::string verdictOf(const std::vector<RunFacts>& runs);

/// HTML: how the run differs from its golden, in words; "" where there is no golden.
std::string changeOf(const RunFacts& run);

/// HTML: all checks with their shares of the tolerances, and the first differences.
std::string checksOf(const std::vector<CheckResult>& checks, const CellNames& names);

}  // namespace morula
