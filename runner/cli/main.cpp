#include "cli/verbs.h"

int main(int argc, char** argv) { return morula::cli::runProgram(argc, argv); }
