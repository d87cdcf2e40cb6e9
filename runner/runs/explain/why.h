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
  // The result is compared with that of a Morula program, or of a run in a database ("": the latest), or else with the
  // golden.
  std::string program, database, run;
  std::uint64_t every = 64;  // [steps] looked at first
  Execution execution;
  bool quiet = false;
};

/// The findings, in the order in which each explains the next.
struct Findings {
  std::string failureClass;  // "" if nothing differs
  Explanation where;
  std::vector<KeyChange> changed;
  std::string text;  // for people
  std::vector<CheckResult> checks;
};

/// Runs the scenario again, twice in different ways first: nothing can be told of a program that is not the same each
/// time. Throws Interrupted if a signal has come.
Findings findWhy(const Scenario& scenario, const WhyQuestion& question);

/// Writes findings for `morula explain --json`.
Json toJson(const Scenario& scenario, const Findings& findings);

}  // namespace morula
