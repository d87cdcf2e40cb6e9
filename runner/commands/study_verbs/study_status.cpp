// morula study status: results, failures, missing runs and the time that they take.

#include <algorithm>
#include <iterator>

#include "files/folders.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "study/plan_difference.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"
#include "tasks/status.h"

namespace morula::cli {
namespace {

int act(const StudyOptions& options) {
  // The folder's plan is used, whatever the file says now.
  const PlannedStudy study = openStudy({.what = options.study,
                                        .to = options.out,
                                        .allowOutside = options.input.allowOutside,
                                        .resume = true,
                                        .mustBeThere = true},
                                       {});
  StudyStatus status = statusOf(study);
  AllowedRuns allowed = study.plan.study.allowed;
  if (!isFolder(options.study)) {
    const Study now = loadStudy(options.study, options.input.allowOutside);
    allowed = now.allowed;
    PlanDifference difference = differenceFrom(parseJson(writePlan(study.plan)), makePlan(now, {.predict = false}));
    status.stale = std::move(difference.stale);
    std::ranges::move(difference.lacking, std::back_inserter(status.stale));
  }
  printEither(options.output, toJson(status, study), describe(status, study));
  return exitCodeOf(status.counts().worst(allowed));
}

}  // namespace

void addStudyStatus(CLI::App& study, Action& action) {
  Verb verb(
      study, action, "status",
      "List which runs have a result, failed, are not sane or are missing; exit code 5: runs are missing, 1: more "
      "failed or are insane than limits allow, or the study file has changed since it was planned");
  add(verb, verb.does<StudyOptions>(act));
}

}  // namespace morula::cli
