#pragma once
// What the runs of a plan are expected to take on this machine: a few conditions are rehearsed, and the others follow.
#include <vector>

#include "study/plan.h"

namespace morula::study {

/// One for each condition. Until `options.rehearsal` is used up, beginnings of runs are made: of the first condition, then of
/// those that differ from it in one axis, in two, and so on. The cost of the others is the first one's, times a factor for
/// each of their levels: the ratio to the first one's cost of the condition that differs from it in that level alone.
std::vector<RunCost> predictCosts(const Plan& plan, const PlanOptions& options);

/// By a rehearsal each; needs plan.costs.
std::vector<SettledCost> predictSettled(const Plan& plan, const PlanOptions& options);

}  // namespace morula::study
