#pragma once
// The command line as a whole: verbs, help, mistakes, exit codes.
#include <functional>
#include <string>

#include "options/verb.h"

namespace morula::cli {

/// Adds all verbs to the command line, in the order in which the help shows them.
using AddVerbs = std::function<void(CLI::App& app, Action& action)>;

/// The whole program: reads the command line, acts, turns exceptions into exit codes.
int runProgram(int argc, char** argv, const AddVerbs& addVerbs);

/// The command line as typed, for the record of a run.
std::string commandLine();

}  // namespace morula::cli
