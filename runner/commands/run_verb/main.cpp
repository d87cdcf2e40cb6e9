#include "options/program.h"
#include "run_verb/run_verb.h"

int main(int argc, char** argv) {
  using namespace morula::cli;
  return runProgram(argc, argv,
                    [](CLI::App& app, Action& action) { addRun(app, action), addEngineWorker(app, action); });
}
