// morula review: shows how goldens would change, with a reason changes them, and tells the errors that they state.
#include <cstdlib>

#include "base/error.h"
#include "check/accept_run.h"
#include "check/check_run.h"
#include "check/pending.h"
#include "cli/stated_errors.h"
#include "cli/verbs.h"
#include "explain/explain.h"
#include "files/folders.h"
#include "files/text.h"
#include "golden/accept.h"
#include "golden/golden_diff.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "system/console.h"
#include "system/git_text.h"
#include "system/installation.h"

namespace morula::cli {
namespace {

std::string usersName() {
  const char* user = std::getenv("USER");
  return user ? user : "";
}

struct ReviewOptions {
  std::vector<std::string> scenarios;  // with `stated` goldens
  InputOptions input;
  ExecutionOptions execution;
  OutputOptions output;
  bool accept = false, reject = false, intoGolden = false, stated = false;
  std::string why, by = usersName();
  StatedErrorsCommand errors;  // only `until` and `budget` come from the command line
};

/// Returns the named scenarios, or else those whose results wait. `--accept` and `--reject` need names.
std::vector<std::string> scenarioFiles(const ReviewOptions& options) {
  if (!options.scenarios.empty()) return options.scenarios;
  std::vector<std::string> waiting;
  const PendingResults pending = pendingResults();
  for (const auto& file : pending.scenarios) waiting.push_back(file.string());
  for (const auto& file : pending.gone)
    tell(file.string() + ": waits for a review of a scenario that is not here; remove it if nobody needs it",
         options.output.quiet);
  if (!options.accept && !options.reject) return waiting;
  std::string command = programWord() + " review";
  for (const auto& file : waiting) command += ' ' + shellWord(file);
  command += std::string(options.accept ? " --accept" : " --reject") + " --why " + shellWord(options.why);
  throw UsageError(std::string(options.accept ? "--accept" : "--reject") + ": name the scenarios that are meant; " +
                   (waiting.empty() ? "no result waits for a review here"
                                    : "results of " + std::to_string(waiting.size()) + " wait here: " + command));
}

/// The result that waits, or else that of a run made for the purpose, which then waits if it differs.
GoldenData resultToReview(const Scenario& scenario, const ReviewOptions& options) {
  if (auto pending = findPending(scenario)) return std::move(*pending);
  const auto run = simulate(scenario, execution(options.execution),
                            {.quiet = options.output.quiet, .record = recordingOf(scenario, true)});
  if (run.end.status != RunStatus::done) throw InputError(scenario.file + ": " + run.end.failure);
  auto observed = observe(scenario, run);
  const auto file = goldenFile(scenario);
  if (!fileExists(file) || !compareGolden(readGoldenFile(file), observed).passed())
    putPending(scenario, run, observed, execution(options.execution), options.output.quiet);
  return observed;
}

/// Describes tolerances that were loosened since the last commit: people may edit them, but reviewers must see it.
std::string describeLoosened(const Golden& golden, const std::filesystem::path& file) {
  const auto committed = committedText(file);
  if (!committed) return {};
  try {
    std::string text;
    for (const auto& line : loosenedTolerances(readGolden(*committed, "the committed " + file.string()), golden))
      text += "  LOOSER  " + line + '\n';
    return text;
  } catch (const InputError&) {
    return "  the committed golden is of another version: look at its tolerances yourself\n";
  }
}

/// Shows the changes of a golden. Returns 0 if there are none.
int show(const Scenario& scenario, const GoldenData& observed, const OutputOptions& output, Json& results) {
  const auto file = goldenFile(scenario);
  Json json{{"scenario", goldenName(scenario.file)}, {"golden", file.string()}};
  std::string text;
  int code = fine;
  if (!fileExists(file)) {
    code = differs;
    text = scenario.file + ": there is no golden yet; " + std::to_string(observed.items.size()) + " items\n";
  } else {
    const Golden golden = readAccepted(scenario, file);
    CheckReport report = compareGolden(golden, observed);
    report.scenario = scenario.file;
    const std::string changes = describeGoldenDiff(golden, observed), looser = describeLoosened(golden, file);
    if (!report.passed() || !looser.empty()) code = differs;
    text = describe(report) + changes + looser;
    json["changes"] = changes, json["loosened"] = looser;
  }
  if (code == differs)
    for (const auto& [what, path] :
         {std::pair{"  waits    ", pendingFile(scenario)}, std::pair{"  picture  ", pendingPicture(scenario)}})
      if (fileExists(path)) text += what + path.string() + '\n';
  json["passed"] = code == fine;
  results.push_back(json);
  if (!output.json) print(text);
  return code;
}

int act(const ReviewOptions& options) {
  if (options.intoGolden || options.stated) {
    StatedErrorsCommand errors = options.errors;
    errors.files = options.scenarios, errors.input = options.input;
    errors.execution = options.execution, errors.output = options.output;
    return options.stated ? printStatedErrors(errors) : stateErrors(errors);
  }
  if (options.accept && options.by.empty()) throw UsageError("--accept: whose name does it carry? Give --by NAME, too");
  std::vector<Scenario> scenarios;
  for (const auto& file : scenarioFiles(options)) {
    scenarios.push_back(loadScenario(file, {}, options.input.allowOutside));
    if (options.accept) requireAcceptable(goldenFile(scenarios.back()).string(), {options.by, options.why});
  }
  for (const auto& scenario : scenarios)
    if (options.reject && !findPending(scenario))
      throw FileError(goldenName(scenario.file) + ": no result waits for a review, so there is none to reject");
  if (scenarios.empty()) tell("no result waits for a review", options.output.quiet);

  int code = fine;
  Json results = Json::array();
  for (const auto& scenario : scenarios) {
    if (options.reject) {
      removePending(scenario);
      results.push_back({{"scenario", goldenName(scenario.file)}, {"rejected", options.why}});
      if (!options.output.json) print("rejected: " + scenario.file + ": " + options.why + "\n");
      continue;
    }
    if (!options.accept) {
      code = std::max<int>(code, show(scenario, resultToReview(scenario, options), options.output, results));
      continue;
    }
    const auto accepted =
        acceptRun(scenario, execution(options.execution), {options.by, options.why}, options.output.quiet);
    if (!options.output.json)
      print(accepted.nondeterministic ? "nothing accepted. " + explainTwice(scenario, execution(options.execution)).text
                                      : accepted.text);
    results.push_back({{"scenario", goldenName(scenario.file)},
                       {"accepted", accepted.done},
                       {"file", goldenFile(scenario).string()}});
    if (!accepted.done) code = differs;
    else removePending(scenario);
  }
  if (options.output.json) printJson({{"results", results}});
  return code;
}

}  // namespace

void addReview(CLI::App& app, Action& action) {
  Verb verb(app, action, "review",
            "Show what golden files would change, and accept or reject it with a reason; or state their errors");
  auto& options = verb.does<ReviewOptions>(act);
  verb.takes("scenario", options.scenarios, "FILE",
             "Scenario files, with --stated golden files; default: those whose results wait in this project, to look "
             "at");
  verb.takes("--accept", options.accept, "Run twice more and write the golden files");
  verb.takes("--reject", options.reject, "Throw the waiting results away");
  verb.takes("--why", options.why, "TEXT", "What changed and why the new result is right, or is not");
  verb.takes("--into-golden", options.intoGolden,
             "Measure the error of each scenario as it is, and write it into its golden file");
  verb.takes("--until", options.errors.until, "T", number(scenario::positive),
             "Measure errors up to this time; default: the latest for which they can be known");
  verb.takes("--budget", options.errors.budget, "SECONDS", number(scenario::positive),
             "Max CPU time of the runs on finer meshes");
  verb.takes("--stated", options.stated, "Print the errors that these golden files state, as golden/ERRORS.md does");
  verb.oneOf({"--accept", "--reject", "--into-golden", "--stated"});
  verb.onlyWith({"--until", "--budget"}, {"--into-golden"});
  verb.excludes("--stated", {"--json"}, "--stated prints Markdown");
  verb.onlyWith({"--accept", "--reject"}, {"--why"});
  verb.onlyWith({"--why"}, {"--accept", "--reject"});
  verb.takes("--by", options.by, "NAME", "Who accepts; default: the user's name");
  verb.onlyWith({"--by"}, {"--accept"});
  add(verb, options.input);
  add(verb, options.execution);
  add(verb, options.output);
}

}  // namespace morula::cli
