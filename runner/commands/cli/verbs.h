#pragma once
// The verbs of the program: each adds its subcommand to the command line and, when it was chosen, the action.
#include "options/verb.h"

namespace morula::cli {

void addRun(CLI::App& app, Action& action);
void addParts(CLI::App& app, Action& action);
void addCheck(CLI::App& app, Action& action);
void addExplain(CLI::App& app, Action& action);
void addReview(CLI::App& app, Action& action);
void addValidate(CLI::App& app, Action& action);
void addSchema(CLI::App& app, Action& action);
void addInit(CLI::App& app, Action& action);
void addRender(CLI::App& app, Action& action);
void addLineage(CLI::App& app, Action& action);
void addChart(CLI::App& app, Action& action);
void addReplay(CLI::App& app, Action& action);
void addExport(CLI::App& app, Action& action);
void addReport(CLI::App& app, Action& action);
void addAccuracy(CLI::App& app, Action& action);
void addBench(CLI::App& app, Action& action);
void addTrail(CLI::App& app, Action& action);
void addEngineWorker(CLI::App& app, Action& action);

/// All of them, and those of study_verbs/study_verbs.h.
void addVerbs(CLI::App& app, Action& action);

}  // namespace morula::cli
