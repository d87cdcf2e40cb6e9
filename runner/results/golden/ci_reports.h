#pragma once
// Check reports in the forms that continuous integration reads.
#include <string>
#include <vector>

#include "golden/check_result.h"

namespace morula {

/// JUnit's XML: a suite for each scenario, a case for each check. For each cause one failure, of the class's type, with
/// what changed in words, all that differs and what follows from it; the checks that only follow are skipped.
std::string junitXml(const std::vector<CheckReport>& reports);

/// Workflow commands, one line for each cause: `::error file=…,line=…,title=…::what changed, in words`. Not more than
/// `most`, as services show only so many, and then one that says how many more there are. "" when all pass.
std::string annotations(const std::vector<CheckReport>& reports, std::size_t most = 9);

/// A Markdown table of the scenarios, and under it for each cause what changed, in words, and what to type next.
std::string summaryPage(const std::vector<CheckReport>& reports);

/// In a workflow of GitHub: prints the annotations, unless what is printed is JSON, and adds the summary to the
/// workflow's page.
void tellWorkflow(const std::vector<CheckReport>& reports, bool json);

}  // namespace morula
