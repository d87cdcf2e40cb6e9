// morula schema: what a scenario may say, and what is measured.
#include "scenario/schema.h"

#include <memory>

#include "cli/exit_codes.h"
#include "cli/verb.h"
#include "system/console.h"
#include "values/measure_list.h"

namespace morula::cli {

void addSchema(CLI::App& app, Action& action) {
  auto markdown = std::make_shared<bool>(false), measures = std::make_shared<bool>(false);
  Verb verb(app, action, "schema", "Print the JSON Schema of scenarios, for editors");
  verb.takes("--markdown", *markdown, "As tables for people instead: scenarios/PARAMETERS.md");
  verb.takes("--measures", *measures, "What is measured instead; with --markdown: scenarios/MEASURES.md");
  verb.does([markdown, measures] {
    if (*measures) print(*markdown ? measuresAsMarkdown() : measuresAsJson());
    else print(*markdown ? scenarioParametersAsMarkdown() : scenarioSchema());
    return fine;
  });
}

}  // namespace morula::cli
