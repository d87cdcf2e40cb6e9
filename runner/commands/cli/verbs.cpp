#include "cli/verbs.h"

#include "run_verb/run_verb.h"
#include "study_verbs/study_verbs.h"

namespace morula::cli {

static constexpr AddVerb* all[] = {addRun,        addParts,    addCheck, addExplain, addReview,  addValidate, addSchema,
                                   addInit,       addRender,   addChart, addLineage, addReplay,  addExport,   addReport,
                                   addPlayground, addAccuracy, addBench, addStudy,   addCompare, addInternal};
const std::span<AddVerb* const> verbs = all;

}  // namespace morula::cli
