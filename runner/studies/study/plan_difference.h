#pragma once
// The differences between a stored plan and the study file with its scenarios as they are now.
#include <cstddef>
#include <string>
#include <vector>

#include "study/plan.h"
#include "system/json.h"

namespace morula {

struct PlanDifference {
  std::vector<std::string> stale;    // a sentence for each change that makes stored results differ from those asked for
  std::vector<std::string> lacking;  // a sentence on replicates that the stored plan does not have
  std::size_t missing = 0;           // number of those replicates

  bool isNone() const { return stale.empty() && lacking.empty(); }
};

/// `stored`: the plan's file as JSON (writePlan). Throws Json::exception if it is invalid.
PlanDifference differenceFrom(const Json& stored, const Plan& now);

}  // namespace morula
