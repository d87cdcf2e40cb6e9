#pragma once
// The errors that goldens state, as `morula review` writes and prints them.
#include <optional>
#include <string>
#include <vector>

#include "options/options.h"

namespace morula::cli {

struct StatedErrorsCommand {
  std::vector<std::string> files;  // scenarios; for `printStatedErrors` goldens
  std::optional<double> until;     // [time] end of the comparison; absent: the latest that is possible
  double budget = 120;             // [s] max CPU time of the runs on finer meshes
  InputOptions input;
  ExecutionOptions execution;
  OutputOptions output;
};

/// Measures the error of each scenario as it is, and writes it into the scenario's golden. Of several scenarios, those
/// without an error to state are reported and skipped. Returns the exit code.
int stateErrors(const StatedErrorsCommand& command);

/// Prints the errors that golden files of scenes with bodies state, as golden/ERRORS.md does.
int printStatedErrors(const StatedErrorsCommand& command);

}  // namespace morula::cli
