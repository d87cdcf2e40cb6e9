#pragma once
// Steps of making a plan that reading one needs, too.
#include "study/plan.h"

namespace morula::study {

/// Tasks and replicates, from the conditions.
void addTasks(Plan& plan);

/// Plan::id, of a plan that is otherwise complete.
std::string planId(const Plan& plan);

/// Makes files and places relative to the study's folder, so that a plan is the same wherever it was made from.
void countFromFolder(Plan& plan);

}  // namespace morula::study
