#pragma once
// A plan as rows of the merged database.
#include "store/merged_study.h"
#include "study/plan.h"

namespace morula {

StudyTables tablesOf(const Plan& plan);

}  // namespace morula
