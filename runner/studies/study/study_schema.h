#pragma once
// The keys of a study file for editors and for people.
#include <string>

namespace morula {

/// A JSON Schema (draft 2020-12) of study files. Ends with a newline.
std::string studySchema();

/// Writes the keys as a Markdown table: scenarios/STUDIES.md.
std::string studyKeysAsMarkdown();

/// A commented study to begin with, named `name`, of the scenario `base`. It loads once that scenario is there.
std::string starterStudy(const std::string& name, const std::string& base);

}  // namespace morula
