#pragma once
// The differences of a stored plan from the study file and its scenarios as they are now.
#include <cstddef>
#include <string>
#include <vector>

#include "study/plan.h"
#include "system/json.h"

namespace morula {

struct PlanDifference {
  std::vector<std::string> stale;    // a sentence for each difference by which results are not those that are asked for
  std::vector<std::string> lacking;  // a sentence on replicates that the stored plan does not have
  std::size_t missing = 0;           // their number

  bool isNone() const { return stale.empty() && lacking.empty(); }
};

/// `stored`: the plan's file as JSON (writePlan). Throws Json::exception if it is none.
PlanDifference differenceFrom(const Json& stored, const Plan& now);

}  // namespace morula
