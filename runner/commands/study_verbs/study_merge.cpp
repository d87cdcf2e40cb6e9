// morula study merge: all runs of a study in one database.
#include <memory>

#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"
#include "tasks/merge.h"

namespace morula::cli {

namespace {

struct MergeCommand {
  std::string study, to, output;
  std::vector<std::string> shards;
  InputOptions input;
  OutputOptions messages;
};

int act(const MergeCommand& command) {
  const PlannedStudy study =
      openStudy({command.study, command.to, command.input.allowOutside, true, true}, {});
  const MergeReport report = mergeStudy(
      study, {command.shards, command.output.empty() ? study.folder.merged().string() : command.output});
  if (command.messages.json) printJson(toJson(report, study));
  else print(describe(report, study));
  if (!report.differing.empty()) return differs;
  if (!report.damaged.empty()) return file;
  return report.missing.empty() ? fine : incomplete;
}

}  // namespace

void addStudyMerge(CLI::App& study, Action& action) {
  auto command = std::make_shared<MergeCommand>();
  Verb verb(study, action, "merge",
            "Verify all results and put them into one database; exit code 5: runs are missing, 1: one run "
            "has two results");
  verb.needs("study", command->study, "FILE|DIR", "A study file, or the folder of a study");
  verb.takes("shards", command->shards, "SHARD",
             "Folders of the same study on other machines, or files of tasks");
  verb.takes("--to", command->to, "DIR", "The study's folder; default: results/studies/NAME");
  verb.takes("-o,--output", command->output, "FILE", "The database; default: study.db in the study's folder");
  add(verb, command->input);
  add(verb, command->messages);
  verb.does([command] { return act(*command); });
}

}  // namespace morula::cli
