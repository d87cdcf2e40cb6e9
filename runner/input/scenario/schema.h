#pragma once
// The table of parameters for editors and for people, and a scenario to begin with.
#include <string>

namespace morula {

/// Returns a JSON Schema (draft 2020-12), by which editors complete and check scenarios. The text ends with a newline.
std::string scenarioSchema();

/// Returns the parameters as Markdown tables: scenarios/PARAMETERS.md.
std::string scenarioParametersAsMarkdown();

/// Returns a commented scenario to begin with, named `name`, that loads without problems.
std::string starterScenario(const std::string& name);

}  // namespace morula
