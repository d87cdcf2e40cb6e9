#pragma once
// `morula study`, the verbs below it, and `morula compare`, which is also one of them.
#include "options/options.h"
#include "tasks/study_folder.h"

namespace morula::cli {

AddVerb addStudy, addCompare;

// Below `study`.
AddVerb addStudyPlan, addStudyRun, addStudyStatus, addStudyMerge, addStudyEmit;

/// What all verbs that work on a study's folder are told.
struct StudyOptions {
  std::string study, out;
  InputOptions input;
  OutputOptions output;
};

void add(Verb& verb, StudyOptions& options);
/// `--out` alone, of `study plan`, which takes no folder of a study.
void addStudyFolder(Verb& verb, std::string& out);

}  // namespace morula::cli
