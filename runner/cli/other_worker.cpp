// morula other-worker: a scenario's run by another engine, for the program itself. Not for people.
#include "cli/exit_codes.h"
#include "cli/verb.h"
#include "engines/external_run.h"
#include "system/console.h"

namespace morula::cli {

void addOtherWorker(CLI::App& app, Action& action) {
  Verb verb(app, action, "other-worker",
            "Runs one scenario in another engine: question on stdin, answer on stdout");
  verb.hide();  // not listed
  verb.does([] {
    serveOtherRun(questionStream(), answerStream());
    return fine;
  });
}

}  // namespace morula::cli
