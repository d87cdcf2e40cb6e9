#pragma once
// What the runs of a plan are expected to take on this machine: a few conditions are rehearsed, and the others follow.
#include <vector>

#include "study/plan.h"

namespace morula::study {

/// One for each condition. Rehearsed are, until `options.rehearsal` is used up, the first condition, those that differ from
/// it in one axis, in two, and so on. Others take the first one's cost, times the ratio to it of each of their levels alone.
std::vector<RunCost> predictCosts(const Plan& plan, const PlanOptions& options);

}  // namespace morula::study
