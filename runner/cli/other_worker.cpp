// morula other-worker: a scenario's run by another engine, for the program itself. Not for people.
#include <CLI/CLI.hpp>
#include <iostream>

#include "cli/exit_codes.h"
#include "cli/other_run.h"
#include "cli/verbs.h"

namespace morula::cli {

void addOtherWorker(CLI::App& app, Action& action) {
  auto* verb = app.add_subcommand("other-worker",
                                  "Runs one scenario in another engine: question on stdin, answer on stdout");
  verb->group("");  // not listed
  verb->callback([&action] {
    action = [] {
      serveOtherRun(std::cin, std::cout);
      return fine;
    };
  });
}

}  // namespace morula::cli
