// morula study status: what has a result, what failed, what is missing, what it takes.
#include <memory>

#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"
#include "tasks/status.h"

namespace morula::cli {

namespace {

struct StatusCommand {
  std::string study, to;
  InputOptions input;
  OutputOptions output;
};

int act(const StatusCommand& command) {
  // Whatever the file says by now: the question is about what is there.
  const PlannedStudy study =
      openStudy({command.study, command.to, command.input.allowOutside, true, true}, {});
  const StudyStatus status = statusOf(study);
  if (command.output.json) printJson(toJson(status, study));
  else print(describe(status, study));
  return status.isComplete() ? fine : incomplete;
}

}  // namespace

void addStudyStatus(CLI::App& study, Action& action) {
  auto command = std::make_shared<StatusCommand>();
  Verb verb(study, action, "status",
            "Tell which runs have a result, failed or are missing; exit code 5: some are missing");
  verb.needs("study", command->study, "FILE|DIR", "A study file, or the folder of a study");
  verb.takes("--to", command->to, "DIR", "The study's folder; default: results/studies/NAME");
  add(verb, command->input);
  add(verb, command->output);
  verb.does([command] { return act(*command); });
}

}  // namespace morula::cli
