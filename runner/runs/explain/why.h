#pragma once
// Finds where and why a scenario's result differs from that of another program, of a stored run, or of its golden.
#include <string>
#include <vector>

#include "explain/explain.h"
#include "golden/change.h"
#include "golden/check_result.h"
#include "scenario/scenario.h"
#include "system/json.h"

namespace morula {

struct WhyQuestion {
  // The result is compared with that of a Morula program; of a run in a database, "" for the latest; or of the golden.
  std::string program, database, run;
  std::uint64_t every = 64;  // [steps] between the first comparisons
  Execution execution;
  bool quiet = false;
};

/// The findings, in an order in which each explains the next.
struct Findings {
  FailureClass failureClass = FailureClass::none;
  Explanation where;
  std::vector<KeyChange> changed;
  std::string text;  // for people
  std::vector<CheckResult> checks;
};

/// Runs the scenario twice in different ways: if these differ, no comparison means anything. Then runs it again to
/// compare. Throws Interrupted if a signal has come.
Findings findWhy(const Scenario& scenario, const WhyQuestion& question);

/// Writes findings for `morula explain --json`.
Json toJson(const Scenario& scenario, const Findings& findings);

}  // namespace morula
