#include "options/program.h"
#include "run_verb/run_verb.h"

int main(int argc, char** argv) {
  using namespace morula::cli;
  AddVerb* const verbs[] = {addRun, addEngineWorker};
  return runProgram(argc, argv, verbs);
}
