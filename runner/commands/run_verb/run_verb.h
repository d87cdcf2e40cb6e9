#pragma once
// `morula run`, and the verb by which a run asks another engine. With main.cpp they are a program of their own,
// morula-run, which has what `run` needs and nothing else: ../../../morula builds it for the first call.
#include "options/verb.h"

namespace morula::cli {

AddVerb addRun, addEngineWorker;

}  // namespace morula::cli
