#pragma once
// The verbs of the program: each adds its subcommand to the command line and, when it was chosen, the action.
#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace morula::cli {

/// What is to be done once the command line is understood. Returns the exit code.
using Action = std::function<int()>;

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
void addAccuracy(CLI::App& app, Action& action);
void addBench(CLI::App& app, Action& action);
void addStudy(CLI::App& app, Action& action);
void addCompare(CLI::App& app, Action& action);
void addTrail(CLI::App& app, Action& action);
void addEngineWorker(CLI::App& app, Action& action);

// Below `study`, in the order in which they are used.
void addStudyPlan(CLI::App& study, Action& action);
void addStudyRun(CLI::App& study, Action& action);
void addStudyStatus(CLI::App& study, Action& action);
void addStudyMerge(CLI::App& study, Action& action);
void addStudyCompare(CLI::App& study, Action& action);
void addStudyEmit(CLI::App& study, Action& action);

/// The command line as typed, for the record of a run.
std::string commandLine();

/// The whole program: reads the command line, acts, turns exceptions into exit codes.
int runProgram(int argc, char** argv);

}  // namespace morula::cli
