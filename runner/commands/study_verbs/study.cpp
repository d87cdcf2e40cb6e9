// morula study: from a study file to its answer. One file per verb below it: study_plan.cpp, …
#include "options/verb.h"
#include "study_verbs/study_verbs.h"

namespace morula::cli {

void addStudy(CLI::App& app, Action& action) {
  auto& study =
      addGroup(app, "study", "Vary scenarios by policies and seeds, run them all, compare what comes of it");
  addStudyPlan(study, action);
  addStudyRun(study, action);
  addStudyStatus(study, action);
  addStudyMerge(study, action);
  addStudyCompare(study, action);
  addStudyEmit(study, action);
}

}  // namespace morula::cli
