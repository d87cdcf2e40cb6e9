// morula report: one page on stored runs, which opens anywhere and needs no network.
#include "report/report.h"

#include "base/error.h"
#include "cli/verbs.h"
#include "files/folders.h"
#include "files/write_file.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "study/study_file.h"
#include "study_verbs/study_verbs.h"
#include "system/console.h"

namespace morula::cli {

namespace fs = std::filesystem;

namespace {

struct ReportOptions {
  ReportQuestion question;
  double limit = 4e6;   // [byte]
  std::string output;
  bool noBullet = false;
  ExecutionOptions execution;
  OutputOptions messages;
};

/// Returns results/unique-four-5/report.html for results/unique-four-5/run.db.
fs::path defaultName(const std::string& what) {
  const fs::path path = what;
  return (isFolder(path) ? path : path.parent_path()) / "report.html";
}

int act(const ReportOptions& options) {
  ReportQuestion question = options.question;
  question.maxBytes = static_cast<std::size_t>(options.limit);
  question.execution = execution(options.execution);
  question.bullet = !options.noBullet;
  question.quiet = options.messages.quiet;
  // A study file stands for its results; its scenarios may lie anywhere.
  for (std::string& what : question.what)
    if (isStudyFile(what) && isPlainFile(what) && isStudy(what)) what = databaseOf(what, true).string();
  findExplorer(question);
  const fs::path file = options.output.empty() ? defaultName(question.what.front()) : fs::path(options.output);
  const ReportAnswer answer = makeReport(question);
  writeFile(file, answer.bytes, Content::page);
  if (question.program.empty()) tell("report: without the explorer: " + question.whyNone, options.messages.quiet);
  for (const std::string& remark : answer.remarks) tell("report: " + remark, options.messages.quiet);
  printEither(options.messages,
              {{"report", file.string()},
               {"runs", answer.runs},
               {"bytes", answer.bytes.size()},
               {"explorer", !question.program.empty()}},
              file.string() + "\n");
  return fine;
}

}  // namespace

void addReport(CLI::App& app, Action& action) {
  Verb verb(app, action, "report", "Write one page of stored runs: verdict, explorer, pictures, checks, provenance");
  auto& options = verb.does<ReportOptions>(act);
  verb.needs("what", options.question.what, "WHAT",
             "Databases of runs or of a merged study, files of studies that have been run, report.json of a check, "
             "output of accuracy --json, or folders of these");
  verb.takes("-o,--output", options.output, "FILE", readPageName,
             "The page, a .html; default: report.html beside the first database");
  verb.takes("--run", options.question.run, "ID",
             "Show only this run of the database, for a study also 'CONDITION, seed N'; default: all");
  verb.takes("--explore", options.question.explored, "N", natural(1, 1000),
             "Number of a study's runs that the explorer offers, if they fit into the page; the conditions that "
             "differ most come first");
  verb.showDefault("--explore", "24");
  verb.takes("--frames", options.question.frames, "N", natural(0, 10'000),
             "Number of shapes of each run, evenly over its time; 0: no shapes, and no run is repeated");
  verb.takes("--size-limit", options.limit, "SIZE", readSize,
             "Max size of the page; frames that do not fit are left out, and the page says so");
  verb.showDefault("--size-limit", "4M");
  verb.takes("--no-bullet", options.noBullet, "Do not run Bullet beside Morula for scenarios with check.bullet");
  verb.takes("--rerun", options.question.rerun,
             "Put the simulator into the page, so that its readers can repeat the run");
  add(verb, options.execution);
  add(verb, options.messages);
}

}  // namespace morula::cli
