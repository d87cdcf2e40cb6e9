#pragma once
// A plan as rows of the merged database.
#include "study/plan.h"
#include "study_store/merged_study.h"

namespace morula {

StudyTables tablesOf(const Plan& plan);

}  // namespace morula
