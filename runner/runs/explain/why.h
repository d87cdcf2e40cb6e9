#pragma once
// Where and why a scenario's result is not the expected one: against another program, a stored run, or its golden.
#include <string>
#include <vector>

#include "explain/explain.h"
#include "golden/change.h"
#include "golden/check_result.h"
#include "scenario/scenario.h"
#include "system/json.h"

namespace morula {

struct WhyQuestion {
  // What the result is held against: a Morula program, or a database and a run of it ("": the latest); else the golden.
  std::string program, database, run;
  std::uint64_t every = 64;  // [steps] looked at first
  Execution execution;
  bool quiet = false;
};

/// What was found, in the order in which one finding explains the next.
struct Findings {
  std::string failureClass;  // "" if nothing differs
  Explanation where;
  std::vector<KeyChange> changed;
  std::string text;  // for people
  std::vector<CheckResult> checks;
};

/// Runs the scenario again, twice in different ways first: nothing can be told of a program that is not the same each time.
/// Throws Interrupted if a signal has come.
Findings findWhy(const Scenario& scenario, const WhyQuestion& question);

/// As `morula explain --json` shows it.
Json toJson(const Scenario& scenario, const Findings& findings);

}  // namespace morula
