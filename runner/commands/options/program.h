#pragma once
// The command line as a whole: verbs, help, mistakes, exit codes.
#include <span>
#include <string>

#include "options/verb.h"

namespace morula::cli {

/// The whole program: reads the command line, acts, turns exceptions into exit codes. Help shows `verbs` in that order.
int runProgram(int argc, char** argv, std::span<AddVerb* const> verbs);

/// The command line as typed, for the record of a run.
std::string commandLine();

}  // namespace morula::cli
