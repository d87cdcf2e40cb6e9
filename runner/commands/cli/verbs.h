#pragma once
// The verbs of the program, each in the file of its name; `run` in run_verb/run_verb.h, the verbs of studies in
// study_verbs/study_verbs.h.
#include <span>

#include "options/verb.h"

namespace morula::cli {

AddVerb addParts, addCheck, addExplain, addReview, addValidate, addSchema, addInit, addRender, addChart, addLineage,
    addReplay, addExport, addReport, addPlayground, addAccuracy, addBench, addInternal;

// Verbs below `internal`.
AddVerb addTrail, addDescribe;

/// All verbs, in the order in which the help shows them.
extern const std::span<AddVerb* const> verbs;

}  // namespace morula::cli
