#pragma once
// `morula study`, the verbs below it, and `morula compare`, which is also one of them.
#include "options/verb.h"

namespace morula::cli {

void addStudy(CLI::App& app, Action& action);
void addCompare(CLI::App& app, Action& action);

// Below `study`, in the order in which they are used.
void addStudyPlan(CLI::App& study, Action& action);
void addStudyRun(CLI::App& study, Action& action);
void addStudyStatus(CLI::App& study, Action& action);
void addStudyMerge(CLI::App& study, Action& action);
void addStudyCompare(CLI::App& study, Action& action);
void addStudyEmit(CLI::App& study, Action& action);

}  // namespace morula::cli
