#pragma once
// The table of parameters for editors and for people, and a scenario to begin with.
#include <string>

namespace morula {

/// A JSON Schema (draft 2020-12): editors complete and check scenarios by it. Ends with a newline.
std::string scenarioSchema();

/// Writes the parameters as Markdown tables: scenarios/PARAMETERS.md.
std::string scenarioParametersAsMarkdown();

/// A commented scenario to begin with, named `name`. It loads.
std::string starterScenario(const std::string& name);

}  // namespace morula
