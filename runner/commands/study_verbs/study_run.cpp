// morula study run: computes the planned runs of a study, or a share of them.
#include <algorithm>

#include "base/did_you_mean.h"
#include "files/folders.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/program.h"
#include "options/verb.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"
#include "system/usable_memory.h"
#include "tasks/merge.h"
#include "tasks/run_study.h"

namespace morula::cli {
namespace {

struct RunCommand {
  StudyOptions of;
  int jobs = 1;
  std::optional<Shard> shard;
  std::vector<std::string> tasks;
  ExecutionOptions execution;
  bool resume = false, update = false, retryFailed = false, dryRun = false, noPredict = false;
};

std::size_t taskNamed(const Plan& plan, const std::string& id) {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < plan.tasks.size(); ++i) {
    if (plan.tasks[i].id == id) return i;
    ids.push_back(plan.tasks[i].id);
  }
  const auto near = closest(id, ids);
  throw UsageError("--task: '" + id + "' is not a task of this plan" +
                   (near.empty() ? "; morula study status --json lists the tasks without a result"
                                 : "; did you mean " + near + "?"));
}

std::vector<std::size_t> chosenTasks(const RunCommand& command, const Plan& plan) {
  if (command.tasks.empty()) return tasksOf(command.shard.value_or(Shard{}), plan.tasks.size());
  std::vector<std::size_t> tasks;
  for (const std::string& id : command.tasks) tasks.push_back(taskNamed(plan, id));
  std::ranges::sort(tasks);
  tasks.erase(std::unique(tasks.begin(), tasks.end()), tasks.end());
  return tasks;
}

/// Gives each run its share of the machine's memory.
Execution executionOf(const RunCommand& command) {
  Execution how = execution(command.execution);
  if (!command.execution.memoryLimit) how.memoryLimit /= command.jobs;
  return how;
}

/// Returns the limits of the study file as it is now, if one is named; a continued plan may hold an older text.
AllowedRuns allowedOf(const RunCommand& command, const Plan& plan) {
  return isFolder(command.of.study) ? plan.study.allowed
                                    : loadStudy(command.of.study, command.of.input.allowOutside).allowed;
}

int tellPlan(const RunCommand& command, const PlannedStudy& study, const std::vector<std::size_t>& tasks) {
  std::size_t there = 0;
  for (const std::size_t task : tasks) there += fileExists(study.folder.task(study.plan.tasks[task].id));
  if (command.of.output.json) {
    Json json = summaryOf(study.plan);
    json["folder"] = study.folder.path().string();
    json["asked"] = tasks.size();
    json["already"] = there;
    printJson(json);
  } else {
    print(describe(study.plan) + "would compute " + std::to_string(tasks.size() - there) + " runs into " +
          study.folder.path().string() + "; " + std::to_string(there) + " are there\n");
  }
  return fine;
}

/// Returns the exit code by the states of a whole study. A share is complete or not, and is judged once it is merged.
int exitCodeOf(const RunStudyReport& report, const MergeReport* merged, const AllowedRuns& allowed) {
  if (report.signal) return signalled + report.signal;
  if (merged && !merged->differing.empty()) return differs;
  if (merged) return morula::exitCodeOf(merged->counts().worst(allowed));
  return report.isComplete() ? fine : incomplete;
}

int act(const RunCommand& command) {
  PlanOptions planning;
  planning.predict = !command.noPredict;
  planning.execution = execution(command.execution);
  // Runs are forked off this process, which must have no other threads; predictions use one thread.
  planning.execution.threads = 1;
  const PlannedStudy study = openStudy({.what = command.of.study,
                                        .to = command.of.out,
                                        .allowOutside = command.of.input.allowOutside,
                                        .resume = command.resume,
                                        .update = command.update},
                                       planning);
  const std::vector<std::size_t> tasks = chosenTasks(command, study.plan);
  if (command.dryRun) return tellPlan(command, study, tasks);
  if (study.isNew) tell(describe(study.plan), command.of.output.quiet);
  keepPlan(study);
  const RunStudyOptions options{.tasks = tasks,
                                .jobs = command.jobs,
                                .retryFailed = command.retryFailed,
                                .settings = {executionOf(command), commandLine()},
                                .quiet = command.of.output.quiet};
  const RunStudyReport report = runStudy(study, options);
  std::optional<MergeReport> merged;
  if (report.isComplete() && !command.shard && command.tasks.empty())
    merged = mergeStudy(study, {{}, study.folder.merged()});
  if (command.of.output.json) {
    Json json = toJson(report, study);
    if (merged) json["merged"] = toJson(*merged, study);
    printJson(json);
  } else {
    print(describe(report, study) + (merged ? describe(*merged, study) : ""));
  }
  const AllowedRuns allowed = allowedOf(command, study.plan);
  if (merged && !isAcceptable(merged->counts().worst(allowed)))
    tellError(study.plan.study.name + ": " + merged->counts().text() + "; the study's limits allow " +
              std::to_string(allowed.failed) + " failed and " + std::to_string(allowed.insane) + " insane runs");
  return exitCodeOf(report, merged ? &*merged : nullptr, allowed);
}

}  // namespace

void addStudyRun(CLI::App& study, Action& action) {
  Verb verb(study, action, "run", "Compute the runs that have no result yet, and merge the study when it is complete");
  auto& command = verb.does<RunCommand>(act);
  add(verb, command.of);
  verb.takes("--jobs", command.jobs, "N", natural(1, 1024), "Number of runs at a time");
  verb.takes("--shard", command.shard, "N/OF", parseShard,
             "Compute only every OF-th run from the N-th on, for one machine of several: 3/40");
  verb.takes("--task", command.tasks, "ID", "Compute only this run; may repeat");
  verb.oneOf({"--shard", "--task"});
  verb.takes("--resume", command.resume,
             "Continue the plan in the folder, even if the study file has changed since; runs with a result are "
             "never repeated");
  verb.takes("--update", command.update,
             "Plan the changed study file anew, for instance with more seeds or conditions; results of its runs stay");
  verb.oneOf({"--resume", "--update"});
  verb.takes("--retry-failed", command.retryFailed, "Repeat runs that failed, or whose picture is missing");
  verb.takes("--no-predict", command.noPredict, "Do not predict the cost of a new study's runs");
  verb.takes("--dry-run", command.dryRun, "Print the runs that would be computed, and write nothing");
  add(verb, command.execution);
}

}  // namespace morula::cli
