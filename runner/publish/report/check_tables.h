#pragma once
// What a check found, on a page: a table of shares, what differs, and how the result has changed in words.
#include "report_data/words.h"

namespace morula {

/// All checks with their shares of the tolerances, those that failed first and with all that differs.
Document checksOf(const std::vector<CheckResult>& checks, const CellNames& names);

/// A share of a tolerance: in per cent, beyond ten times the tolerance as a multiple; "" where there is none.
std::string shareText(const std::optional<double>& share);

/// The lines of `change`, which changeInWords (golden/change.h) has made.
Table changeTable(const std::string& change, const CellNames& names);

}  // namespace morula
