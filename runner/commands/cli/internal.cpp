// morula internal: the verbs that programs use. It is the only verb that help does not list.
#include "cli/verbs.h"
#include "run_verb/run_verb.h"

namespace morula::cli {

void addInternal(CLI::App& app, Action& action) {
  addInternalVerbs(app, action, {addTrail, addEngineWorker, addDescribe});
}

}  // namespace morula::cli
