#include "options/program.h"
#include "run_verb/run_verb.h"

int main(int argc, char** argv) {
  using namespace morula::cli;
  AddVerb* const verbs[] = {addRun,
                            [](CLI::App& app, Action& action) { addInternalVerbs(app, action, {addEngineWorker}); }};
  return runProgram(argc, argv, verbs);
}
