// morula schema: what a scenario may say.
#include "scenario/schema.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/console.h"
#include "cli/exit_codes.h"
#include "cli/verbs.h"

namespace morula::cli {

void addSchema(CLI::App& app, Action& action) {
  auto markdown = std::make_shared<bool>(false);
  auto* verb = app.add_subcommand("schema", "Print the JSON Schema of scenarios, for editors");
  verb->add_flag("--markdown", *markdown, "As tables for people instead: scenarios/PARAMETERS.md");
  verb->callback([markdown, &action] {
    action = [markdown] {
      print(*markdown ? scenarioParametersAsMarkdown() : scenarioSchema());
      return fine;
    };
  });
}

}  // namespace morula::cli
