#pragma once
// The content of a crate of a merged study, made from its database alone: the study file with its scenarios and all files
// that they name, the values of all runs, the comparison, claims and methods, figures, and the way to repeat it.
#include "export/ro_crate.h"

namespace morula {

/// The study file, its scenarios and the files that they name, at places in the crate that lie to each other as they did.
struct StudyInputs {
  std::vector<CrateFile> files;
  std::string studyFile;  // the place of the study file in the crate
};
/// Throws StoreError if the plan cannot be read, InputError for files that were named by absolute paths.
StudyInputs inputsOf(const std::filesystem::path& database);

/// Returns the files that follow from the database and the program alone: values, comparison, claims and methods. Their
/// bytes are the same on every machine.
std::vector<CrateFile> derivedFiles(const std::filesystem::path& database);

/// Returns the crate without a page. Throws InputError, with the remedy, for a study without a run that is done.
Crate crateOfStudy(const std::filesystem::path& database);

/// Adds README.md, which lists all files and tells how to repeat the study.
void addReadme(Crate& crate, const std::filesystem::path& database);

}  // namespace morula
