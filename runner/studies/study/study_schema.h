#pragma once
// The keys of a study file for editors and for people.
#include <string>

namespace morula {

/// Returns a JSON Schema (draft 2020-12) of study files. The text ends with a newline.
std::string studySchema();

/// Returns the keys as a Markdown table: scenarios/STUDIES.md.
std::string studyKeysAsMarkdown();

/// Returns a commented study to begin with, named `name`, of the scenario `base`, which must exist to load the study.
std::string starterStudy(const std::string& name, const std::string& base);

}  // namespace morula
