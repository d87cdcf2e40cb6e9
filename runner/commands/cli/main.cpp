#include "cli/verbs.h"
#include "options/program.h"

int main(int argc, char** argv) { return morula::cli::runProgram(argc, argv, morula::cli::verbs); }
