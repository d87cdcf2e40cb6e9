#pragma once
// `morula study`, the verbs below it, and `morula compare`.
#include "options/options.h"
#include "tasks/study_folder.h"

namespace morula::cli {

AddVerb addStudy, addCompare;

// Verbs below `study`.
AddVerb addStudyPlan, addStudyRun, addStudyStatus, addStudyMerge, addStudyEmit, addStudyCheck, addStudyExport,
    addStudyReplay;

/// Options of all verbs that work on a study's folder.
struct StudyOptions {
  std::string study, out;
  InputOptions input;
  OutputOptions output;
};

void add(Verb& verb, StudyOptions& options);
/// Adds `--out` alone, for `study plan`, which takes no folder of a study.
void addStudyFolder(Verb& verb, std::string& out);

/// Returns the database of a study: `named` is the database, the folder of a study, or a study file.
std::filesystem::path databaseOf(const std::string& named, bool allowOutside = false);
inline bool isStudyFile(const std::string& named) { return named.ends_with(".yaml") || named.ends_with(".yml"); }

}  // namespace morula::cli
