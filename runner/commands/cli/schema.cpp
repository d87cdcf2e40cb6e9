// morula schema: what a scenario or a study may say, and what is measured.
#include "scenario/schema.h"

#include <memory>

#include "cli/verbs.h"
#include "options/exit_codes.h"
#include "options/verb.h"
#include "study/study_schema.h"
#include "system/console.h"
#include "system/usage_error.h"
#include "values/measure_list.h"

namespace morula::cli {

void addSchema(CLI::App& app, Action& action) {
  auto markdown = std::make_shared<bool>(false), measures = std::make_shared<bool>(false),
       study = std::make_shared<bool>(false);
  Verb verb(app, action, "schema", "Print the JSON Schema of scenarios, for editors");
  verb.takes("--markdown", *markdown, "As tables for people instead: scenarios/PARAMETERS.md");
  verb.takes("--measures", *measures, "What is measured instead; with --markdown: scenarios/MEASURES.md");
  verb.takes("--study", *study, "Of studies instead; with --markdown: scenarios/STUDIES.md");
  verb.does([markdown, measures, study] {
    if (*measures && *study) throw UsageError("--measures and --study: give one of them");
    if (*study) print(*markdown ? studyKeysAsMarkdown() : studySchema());
    else if (*measures) print(*markdown ? measuresAsMarkdown() : measuresAsJson());
    else print(*markdown ? scenarioParametersAsMarkdown() : scenarioSchema());
    return fine;
  });
}

}  // namespace morula::cli
