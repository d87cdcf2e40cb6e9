#include "cli/verbs.h"

#include "run_verb/run_verb.h"
#include "study_verbs/study_verbs.h"

namespace morula::cli {

/// In the order in which the help shows them.
void addVerbs(CLI::App& app, Action& action) {
  for (AddVerb* add :
       {addRun,    addParts, addCheck,   addExplain, addReview,       addValidate, addSchema,     addInit,
        addRender, addChart, addLineage, addReplay,  addExport,       addReport,   addPlayground, addAccuracy,
        addBench,  addStudy, addCompare, addTrail,   addEngineWorker, addDescribe})
    add(app, action);
}

}  // namespace morula::cli
