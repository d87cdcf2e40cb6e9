#pragma once
// Check reports in the forms that continuous integration reads.
#include <string>
#include <vector>

#include "golden/check_result.h"

namespace morula {

/// JUnit's XML: a suite for each scenario, a case for each check, a failure of the class's type with all that
/// differs.
std::string junitXml(const std::vector<CheckReport>& reports);

/// Workflow commands, one line for each failed check: `::error file=…,line=…,title=…::what differs first`.
/// Not more than `most`, as services show only so many, and then one that says how many more there are. ""
/// when all pass.
std::string annotations(const std::vector<CheckReport>& reports, std::size_t most = 9);

/// A Markdown table of the scenarios, and under it what differs.
std::string summaryPage(const std::vector<CheckReport>& reports);

}  // namespace morula
