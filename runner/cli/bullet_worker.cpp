// morula bullet-worker: Bullet in a process of its own, for the program itself. Not for people.
#include "cli/exit_codes.h"
#include "cli/verb.h"
#include "engines/worker.h"
#include "system/console.h"

namespace morula::cli {

void addBulletWorker(CLI::App& app, Action& action) {
  Verb verb(app, action, "bullet-worker", "Runs one scene in Bullet: request on stdin, result on stdout");
  verb.hide();  // not listed
  verb.does([] {
    serveBullet(questionStream(), answerStream());
    return fine;
  });
}

}  // namespace morula::cli
