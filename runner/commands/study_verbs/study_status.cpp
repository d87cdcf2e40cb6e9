// morula study status: what has a result, what failed, what is missing, what it takes.

#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"
#include "tasks/status.h"

namespace morula::cli {
namespace {

int act(const StudyOptions& options) {
  // Whatever the file says by now: the question is about what is there.
  const PlannedStudy study = openStudy({.what = options.study,
                                        .to = options.out,
                                        .allowOutside = options.input.allowOutside,
                                        .resume = true,
                                        .mustBeThere = true},
                                       {});
  const StudyStatus status = statusOf(study);
  printEither(options.output, toJson(status, study), describe(status, study));
  return status.isComplete() ? fine : incomplete;
}

}  // namespace

void addStudyStatus(CLI::App& study, Action& action) {
  Verb verb(study, action, "status",
            "Tell which runs have a result, failed or are missing; exit code 5: some are missing");
  add(verb, verb.does<StudyOptions>(act));
}

}  // namespace morula::cli
