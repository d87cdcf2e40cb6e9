// morula schema: what a scenario may say.
#include "scenario/schema.h"

#include <memory>

#include "cli/exit_codes.h"
#include "cli/verb.h"
#include "system/console.h"

namespace morula::cli {

void addSchema(CLI::App& app, Action& action) {
  auto markdown = std::make_shared<bool>(false);
  Verb verb(app, action, "schema", "Print the JSON Schema of scenarios, for editors");
  verb.takes("--markdown", *markdown, "As tables for people instead: scenarios/PARAMETERS.md");
  verb.does([markdown] {
    print(*markdown ? scenarioParametersAsMarkdown() : scenarioSchema());
    return fine;
  });
}

}  // namespace morula::cli
