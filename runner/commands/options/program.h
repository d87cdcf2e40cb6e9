#pragma once
// The command line as a whole: verbs, help, mistakes, exit codes.
#include <span>
#include <string>

#include "options/verb.h"

namespace morula::cli {

/// Reads the command line, acts, and turns exceptions into exit codes. Help shows `verbs` in this order.
int runProgram(int argc, char** argv, std::span<AddVerb* const> verbs);

/// Returns the command line as typed, for the record of a run.
std::string commandLine();

}  // namespace morula::cli
