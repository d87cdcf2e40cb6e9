// morula study plan: the runs and the costs of a study.

#include "base/error.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "study/plan.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"

namespace morula::cli {
namespace {

struct PlanCommand {
  std::string study, out;
  InputOptions input;
  OutputOptions output;
  bool dryRun = false, noPredict = false;
};

int act(const PlanCommand& command) {
  const Study study = loadStudy(command.study, command.input.allowOutside);
  const Plan plan = makePlan(study, {.predict = !command.noPredict});
  const std::filesystem::path folder = command.out.empty() ? studyFolder(study) : std::filesystem::path(command.out);
  tellWarnings(plan.warnings, command.output.quiet);
  const bool isNew = !command.dryRun && keepPlan(plan, folder);
  const std::string file = planFile(folder).string();
  if (command.output.json) {
    Json members = summaryOf(plan);
    members["file"] = command.dryRun ? Json() : Json(file);
    printJson(members);
  } else {
    print(describe(plan));
    if (!command.dryRun) tell((isNew ? "wrote " : "as planned before in ") + file, command.output.quiet);
  }
  return fine;
}

}  // namespace

void addStudyPlan(CLI::App& study, Action& action) {
  Verb verb(study, action, "plan", "Plan the runs of a study, and predict their cost");
  auto& command = verb.does<PlanCommand>(act);
  verb.needs("study", command.study, "FILE", "A study file");
  addStudyFolder(verb, command.out);
  verb.takes("--dry-run", command.dryRun, "Print the plan, and write nothing");
  verb.takes("--no-predict", command.noPredict, "Do not predict the cost of the runs");
  add(verb, command.input);
  add(verb, command.output);
}

}  // namespace morula::cli
