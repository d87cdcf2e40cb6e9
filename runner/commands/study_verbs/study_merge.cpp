// morula study merge: merges all runs of a study into one database.

#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"
#include "tasks/merge.h"

namespace morula::cli {
namespace {

struct MergeCommand {
  StudyOptions of;
  std::string output;
  std::vector<std::string> shards;
};

int act(const MergeCommand& command) {
  const PlannedStudy study = openStudy({.what = command.of.study,
                                        .to = command.of.out,
                                        .allowOutside = command.of.input.allowOutside,
                                        .resume = true,
                                        .mustBeThere = true},
                                       {});
  const MergeReport report =
      mergeStudy(study, {command.shards, command.output.empty() ? study.folder.merged().string() : command.output});
  printEither(command.of.output, toJson(report, study), describe(report, study));
  if (!report.differing.empty()) return differs;
  if (!report.damaged.empty()) return file;
  return report.missing.empty() ? fine : incomplete;
}

}  // namespace

void addStudyMerge(CLI::App& study, Action& action) {
  Verb verb(study, action, "merge",
            "Verify all results and put them into one database; exit code 5: runs are missing, 1: one run "
            "has two results");
  auto& command = verb.does<MergeCommand>(act);
  add(verb, command.of);
  verb.takes("shards", command.shards, "SHARD", "Folders of this study on other machines, or files of tasks");
  verb.takes("-o,--output", command.output, "FILE", "The database; default: study.db in the study's folder");
}

}  // namespace morula::cli
