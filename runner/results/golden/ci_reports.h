#pragma once
// Check reports in the forms that continuous integration reads.
#include <string>
#include <vector>

#include "golden/check_result.h"

namespace morula {

/// Returns JUnit's XML: a suite for each scenario, a case for each check. Each cause is one failure of the class's
/// type, with the change in words, all differences and what follows. Checks that only follow are skipped.
std::string junitXml(const std::vector<CheckReport>& reports);

/// Returns workflow commands, one line for each cause: `::error file=…,line=…,title=…::the change in words`. `most`:
/// max number of causes, as services show only so many; a last line gives the number of the others. "" when all pass.
std::string annotations(const std::vector<CheckReport>& reports, std::size_t most = 9);

/// Returns a Markdown table of the scenarios, then for each cause the change in words and the commands to type next.
std::string summaryPage(const std::vector<CheckReport>& reports);

/// In a workflow of GitHub: prints the annotations, unless the verb prints JSON, and adds the summary to the workflow's
/// page.
void tellWorkflow(const std::vector<CheckReport>& reports, bool json);

}  // namespace morula
