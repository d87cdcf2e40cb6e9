#pragma once
// `morula run`, and `morula internal engine-worker`, the process that computes a run's scene with another engine. With
// main.cpp these verbs make the program morula-run, which has no other verbs. The script ../../../morula builds it for
// the first call of `run`, since that takes less time than the whole program.
#include "options/verb.h"

namespace morula::cli {

AddVerb addRun, addEngineWorker;

}  // namespace morula::cli
