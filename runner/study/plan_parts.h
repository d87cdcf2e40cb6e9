#pragma once
// The steps of making a plan, which reading one takes, too.
#include "study/plan.h"

namespace morula::study {

/// Tasks and replicates, from the conditions.
void addTasks(Plan& plan);

/// Plan::id, of a plan that is otherwise complete.
std::string planId(const Plan& plan);

/// Lets files and places count from the study's folder, so that a plan says the same wherever it was made from.
void countFromFolder(Plan& plan);

}  // namespace morula::study
