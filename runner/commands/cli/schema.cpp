// morula schema: the keys of scenarios and studies, and the measures.
#include "scenario/schema.h"

#include "cli/verbs.h"
#include "options/exit_codes.h"
#include "options/verb.h"
#include "study/study_schema.h"
#include "system/console.h"
#include "values/measure_list.h"

namespace morula::cli {
namespace {

struct SchemaOptions {
  bool markdown = false, measures = false, study = false;
};

int act(const SchemaOptions& options) {
  if (options.study) print(options.markdown ? studyKeysAsMarkdown() : studySchema());
  else if (options.measures) print(options.markdown ? measuresAsMarkdown() : measuresAsJson());
  else print(options.markdown ? scenarioParametersAsMarkdown() : scenarioSchema());
  return fine;
}

}  // namespace

void addSchema(CLI::App& app, Action& action) {
  Verb verb(app, action, "schema", "Print the JSON Schema of scenarios, for editors");
  auto& options = verb.does<SchemaOptions>(act);
  verb.takes("--markdown", options.markdown, "Print Markdown tables instead, as in scenarios/PARAMETERS.md");
  verb.takes("--measures", options.measures,
             "Print the list of measures instead; with --markdown: scenarios/MEASURES.md");
  verb.takes("--study", options.study, "Print the schema of studies instead; with --markdown: scenarios/STUDIES.md");
  verb.oneOf({"--measures", "--study"});
}

}  // namespace morula::cli
