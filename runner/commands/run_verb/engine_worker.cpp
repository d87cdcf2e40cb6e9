// morula internal engine-worker: a scene computed by another engine, for the program itself. Not for people.
#include "engines/engine_worker.h"

#include "options/exit_codes.h"
#include "options/verb.h"
#include "run_verb/run_verb.h"
#include "system/console.h"

namespace morula::cli {

void addEngineWorker(CLI::App& above, Action& action) {
  Verb verb(above, action, "engine-worker", "Compute one scene: question on stdin, answer on stdout, both JSON");
  verb.does([] {
    serveEngine(questionStream(), answerStream());
    return fine;
  });
}

}  // namespace morula::cli
