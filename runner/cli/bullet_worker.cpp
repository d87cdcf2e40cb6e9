// morula bullet-worker: Bullet in a process of its own, for the program itself. Not for people.
#include <CLI/CLI.hpp>
#include <iostream>

#include "baseline/worker.h"
#include "cli/exit_codes.h"
#include "cli/verbs.h"

namespace morula::cli {

void addBulletWorker(CLI::App& app, Action& action) {
  auto* verb =
      app.add_subcommand("bullet-worker", "Runs one scene in Bullet: request on stdin, result on stdout");
  verb->group("");  // not listed
  verb->callback([&action] {
    action = [] {
      serveBullet(std::cin, std::cout);
      return fine;
    };
  });
}

}  // namespace morula::cli
