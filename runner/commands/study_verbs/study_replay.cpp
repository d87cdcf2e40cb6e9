// morula study replay: repeats runs and the comparison of a study from its crate, and compares the bytes.
#include "export/replay_study.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/program.h"
#include "options/verb.h"
#include "study_verbs/study_verbs.h"

namespace morula::cli {
namespace {

struct ReplayCommand {
  std::string crate;
  std::size_t runs = 2;
  ExecutionOptions execution;
  OutputOptions output;
};

int act(const ReplayCommand& command) {
  Execution how = execution(command.execution);
  const StudyReplay replay = replayStudy(command.crate, command.runs, {how, commandLine()});
  printEither(command.output, toJson(replay), describe(replay));
  return replay.sameBytes() ? fine : differs;
}

}  // namespace

void addStudyReplay(CLI::App& study, Action& action) {
  Verb verb(
      study, action, "replay",
      "Repeat runs and the comparison of a study from its crate, and tell if the bytes are the same; exit code 1: "
      "something differs");
  auto& command = verb.does<ReplayCommand>(act);
  verb.needs("crate", command.crate, "FOLDER", "A crate of morula study export");
  verb.takes("--runs", command.runs, "N", natural(1, 1'000'000),
             "Number of runs to repeat, evenly over the plan; as many as there are: all");
  add(verb, command.execution);
  add(verb, command.output);
}

}  // namespace morula::cli
