// morula study: from a study file to its answer. One file per verb below it: study_plan.cpp, …
#include "study_verbs/study_verbs.h"

namespace morula::cli {

void addStudy(CLI::App& app, Action& action) {
  auto& study = addGroup(app, "study", "Vary scenarios by policies and seeds, run them all, and compare the results");
  // The verbs in the order of their use.
  for (AddVerb* add : {addStudyPlan, addStudyRun, addStudyStatus, addStudyMerge}) add(study, action);
  addAlias(study, "compare");
  for (AddVerb* add : {addStudyCheck, addStudyExport, addStudyReplay, addStudyEmit}) add(study, action);
}

void add(Verb& verb, StudyOptions& options) {
  verb.needs("study", options.study, "FILE|DIR", "A study file, or the folder of a study");
  addStudyFolder(verb, options.out);
  add(verb, options.input);
  add(verb, options.output);
}

void addStudyFolder(Verb& verb, std::string& out) {
  verb.takes("--out", out, "FOLDER", "The study's folder; default: results/studies/NAME");
}

}  // namespace morula::cli
