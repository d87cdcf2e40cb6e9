// morula check: run scenarios again and hold them against their golden files.
#include <algorithm>
#include <map>

#include "base/error.h"
#include "check/check_run.h"
#include "check/pending.h"
#include "check/sanity.h"
#include "cli/verbs.h"
#include "engines/bullet_check.h"
#include "engines/engine_comparison.h"
#include "files/folders.h"
#include "files/printable.h"
#include "files/write_file.h"
#include "golden/accept.h"
#include "golden/ci_reports.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "report/report.h"
#include "system/console.h"
#include "system/json_record.h"

namespace morula::cli {
namespace {

struct CheckOptions {
  std::vector<std::string> scenarios;
  InputOptions input;
  ExecutionOptions execution;
  OutputOptions output;
  std::string reports;
  std::vector<Engine> beside;
  int cpuLimit = usualCpuSeconds;
};

/// As the contract of `morula check --json` says.
Json toJson(const CheckReport& report, const CheckResult& result) {
  Json json{{"scenario", report.scenario}};
  json.update(morula::toJson(result));
  json.erase("message");
  return json;
}

/// All scenarios/…/*.yaml below the working folder but the studies, sorted. Throws FileError if there is no folder `scenarios`.
std::vector<std::string> shippedScenarios() {
  if (!isFolder("scenarios"))
    throw FileError("there is no folder 'scenarios' here; name the scenario files, or go to the project's folder");
  std::vector<std::string> files;
  for (const auto& file : filesBelow("scenarios", ".yaml"))
    if (!file.string().ends_with(".study.yaml")) files.push_back(file.string());
  return files;
}

/// A run that could not end is a check that failed.
CheckReport failed(const Scenario& scenario, const Simulation& run) {
  if (!scenario.check.fails.empty()) return checkStop(scenario, run.end.failure);
  CheckResult result = failedCheck("run", "COMPUTATION", "done", name(run.end.status), run.end.failure);
  result.firstStep = run.end.steps;
  return {goldenName(scenario.file), {result}};
}

/// Runs the scenario and checks it. A result that differs is kept for a review.
CheckReport checkOne(const Scenario& scenario, const Execution& how, bool quiet, int& signal) {
  std::optional<CheckedRun> checked;
  try {
    checked = simulateChecked(scenario, how, {.quiet = quiet, .record = recordingOf(scenario, true)});
  } catch (const InputError& refused) {
    if (scenario.check.fails.empty()) throw;
    return checkStop(scenario, refused.what());
  }
  const Simulation& run = checked->run;
  signal = run.signal;
  if (run.end.status != RunStatus::done) return failed(scenario, run);
  const GoldenData observed = observe(scenario, run);
  CheckReport report = check(scenario, *checked, observed, true);
  if (report.passed()) removePending(scenario);
  else if (scenario.check.fails.empty()) signal = putPending(scenario, run, observed, how, quiet);
  // Not matters for a review: a new golden makes no run sane, and would not bring it and Bullet together.
  report.results.insert(report.results.end(), checked->sanity.begin(), checked->sanity.end());
  for (auto& result : checkAgainstBullet(scenario, run.world, quiet).results)
    report.results.push_back(std::move(result));
  return report;
}

/// By what name each scenario's results are reported: "thesis/unique-four" for …/scenarios/thesis/…, the path
/// as it was given for a file that lies elsewhere, or whose name another one has, too.
std::vector<std::string> reportNames(const std::vector<Scenario>& scenarios) {
  std::map<std::string, int> count;
  for (const auto& s : scenarios) ++count[goldenName(s.file)];
  std::vector<std::string> names;
  for (const auto& s : scenarios) {
    const std::string name = goldenName(s.file);
    const bool elsewhere = !liesInScenarios(s.file);
    names.push_back(elsewhere || count[name] > 1
                        ? std::filesystem::path(s.file).lexically_normal().replace_extension().generic_string()
                        : name);
  }
  return names;
}

bool hasUnusableGolden(const CheckReport& report) {
  return std::any_of(report.results.begin(), report.results.end(),
                     [](const CheckResult& r) { return r.check == "golden" && r.failureClass == "INPUT_CHANGED"; });
}

/// What `morula report` needs beyond the contract: what differs in words, and where the scenarios are.
void addForPage(Json& report, const std::vector<CheckReport>& reports) {
  std::size_t i = 0;
  report["changes"] = report["files"] = Json::object();
  for (const CheckReport& r : reports) {
    if (!r.change.empty()) report["changes"][r.scenario] = r.change;
    if (!r.file.empty()) report["files"][r.scenario] = r.file;
    for (const CheckResult& result : r.results) report["results"][i++]["message"] = result.message;
  }
}

/// report.html, of what report.json says. Returns the signal that interrupted it, or 0.
int writePage(const std::filesystem::path& folder, const Execution& how, bool quiet) {
  ReportQuestion question;
  question.what = {(folder / "report.json").string()};
  question.execution = how, question.quiet = quiet;
  findExplorer(question);
  const ReportAnswer page = makeReport(question);
  if (page.signal == 0) writeFile(folder / "report.html", page.bytes, Content::page);
  return page.signal;
}

/// With the names that the scenario gives its cells.
CheckReport withNames(CheckReport report, const CellNames& names) {
  report.change = morula::withNames(report.change, names.function());
  for (CheckResult& r : report.results) {
    r.message = morula::withNames(r.message, names.function());
    if (r.cell) r.field += " of " + morula::withNames(cellName(*r.cell), names.function());
    r.cell.reset();
  }
  return report;
}

/// `told`: the reports as people read them. `table`: what stands beside, or "".
void writeReports(const std::filesystem::path& folder, const std::vector<CheckReport>& reports,
                  const std::vector<CheckReport>& told, const Json& found, const std::string& table) {
  makeFolder(folder);
  writeFile(folder / "junit.xml", junitXml(told), Content::report);
  Json report{{"morula", 1}};
  report.update(found);
  addForPage(report, reports);
  writeFile(folder / "report.json", printable(jsonText(report, 2)) + '\n', Content::report);
  writeFile(folder / "summary.md", summaryPage(told) + (table.empty() ? "" : "\n" + printable(table)), Content::report);
}

int act(const CheckOptions& options) {
  const auto how = execution(options.execution);
  const ComparisonOptions beside{options.beside, options.cpuLimit, options.output.quiet};
  std::vector<Scenario> scenarios;
  for (const auto& file : options.scenarios.empty() ? shippedScenarios() : options.scenarios)
    scenarios.push_back(loadScenario(file, {}, options.input.allowOutside));

  Json results = Json::array();
  std::vector<CheckReport> reports, told;
  std::vector<Verdict> own;
  int code = fine;
  const auto names = reportNames(scenarios);
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    const Scenario& scenario = scenarios[i];
    int signal = 0;
    CheckReport report = checkOne(scenario, how, options.output.quiet, signal);
    report.scenario = names[i], report.file = scenario.file;
    if (signal) return signalled + signal;
    if (hasUnusableGolden(report)) code = input;
    else if (!report.passed() && code == fine) code = differs;
    for (const auto& result : report.results) results.push_back(toJson(report, result));
    const std::string words = morula::withNames(describe(report), scenario.names.function());
    if (!options.output.json && beside.engines.empty()) print(words);
    else if (!report.passed()) tell(words, options.output.quiet);
    reports.push_back(report), told.push_back(withNames(report, scenario.names));
    if (!beside.engines.empty()) own.push_back(judge(scenario.check, report));
  }
  if (options.scenarios.empty()) {
    for (const auto& file : goldensWithoutScenario("golden", "scenarios")) {
      const std::string why = file.string() + ": there is no scenario to this golden file";
      tellError(why);
      reports.push_back(unusableGolden(file.string(), why)), told.push_back(reports.back());
      results.push_back(toJson(reports.back(), reports.back().results[0]));
      if (code == fine) code = differs;
    }
  }
  Json found{{"results", results}};
  std::string table;
  if (!beside.engines.empty()) {
    const auto rows = compareEngines(scenarios, own, beside);
    found["beside"] = toJson(rows, beside.engines);
    table = comparisonTable(rows, beside.engines);
  }
  if (options.output.json) printJson(found);
  else if (!table.empty()) print(table);
  if (!options.reports.empty()) writeReports(options.reports, reports, told, found, table);
  tellWorkflow(told, options.output.json);
  if (!options.reports.empty())
    if (const int signal = writePage(options.reports, how, options.output.quiet)) return signalled + signal;
  return code;
}

}  // namespace

void addCheck(CLI::App& app, Action& action) {
  Verb verb(app, action, "check", "Run scenarios again and compare them with their golden files");
  auto& options = verb.does<CheckOptions>(act);
  verb.takes("scenario", options.scenarios, "FILE", "Scenario files; default: all under scenarios/");
  verb.takes("--reports", options.reports, "FOLDER",
             "Write junit.xml, report.json, summary.md and the page report.html there");
  verb.takes<std::vector<Engine>>(
      "--beside", options.beside, "ENGINES", parseEngines,
      "Also compute the scenarios with these engines, and print a table of the same checks: thesis "
      "(its contact law), bullet, b1, b2, b3");
  verb.takes("--cpu-limit", options.cpuLimit, "SECONDS", natural(1, 1'000'000), "Max CPU time of each run of --beside");
  verb.onlyWith({"--cpu-limit"}, {"--beside"});
  add(verb, options.input);
  add(verb, options.execution);
  add(verb, options.output);
}

}  // namespace morula::cli
