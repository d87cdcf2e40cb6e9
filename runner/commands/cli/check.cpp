// morula check: runs scenarios again and compares them with their golden files.
#include <algorithm>
#include <map>

#include "base/error.h"
#include "check/check_run.h"
#include "check/pending.h"
#include "check/sanity_check.h"
#include "cli/verbs.h"
#include "engines/bullet_check.h"
#include "engines/engine_comparison.h"
#include "files/content.h"
#include "files/folders.h"
#include "files/printable.h"
#include "files/write_file.h"
#include "golden/accept.h"
#include "golden/ci_reports.h"
#include "golden/project_files.h"
#include "golden/result_state.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "report/report.h"
#include "system/console.h"
#include "system/installation.h"
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

/// Writes a result for `morula check --json`.
Json toJson(const CheckReport& report, const CheckResult& result) {
  Json json{{"scenario", report.scenario}};
  json.update(morula::toJson(result));
  json.erase("message");
  return json;
}

/// Returns all scenarios below the project's folder `scenarios`, sorted. Studies are named on stderr: other verbs check
/// them. Throws FileError if there is no such folder, InputError if it holds nothing to check.
std::vector<std::string> projectScenarios(bool quiet) {
  if (!isFolder("scenarios"))
    throw FileError("there is no folder 'scenarios' here; name the scenario files, or go to the project's folder");
  const ProjectFiles found = projectFiles("scenarios");
  if (found.scenarios.empty())
    throw InputError(
        "scenarios: there is no scenario to check; needs files that end in .yaml or .yml and are no studies");
  std::vector<std::string> files;
  for (const auto& file : found.scenarios) files.push_back(file.string());
  if (const std::size_t studies = found.studies.size())
    tell(std::to_string(studies) + (studies == 1 ? " study" : " studies") +
             " below scenarios that check does not run; run them with `" + programWord() +
             " study run FILE` and check them with `" + programWord() + " study check FILE`, as " +
             found.studies[0].string(),
         quiet);
  return files;
}

/// Returns why files with one golden cannot be checked; "" if no other file has this golden.
std::string sharedGolden(const std::vector<std::string>& files, const std::string& file) {
  for (const std::string& other : files)
    if (other != file && goldenPath(other) == goldenPath(file))
      return file + ": its golden file is the same as that of " + other + ": " + goldenPath(file).string() +
             "; rename one of them";
  return {};
}

/// One scenario of a check.
struct Checked {
  std::string file;
  std::optional<Scenario> scenario;  // absent if it cannot be read
  CheckReport report = {};
  bool isFileError = false;  // the file itself cannot be read
};

/// Makes a failed check of a scenario that cannot be read, or of which no run can be made. The others go on.
void noteUnread(Checked& checked, const std::string& why, bool isFileError) {
  checked.scenario.reset();
  checked.isFileError = isFileError;
  checked.report = {checked.file,
                    {failedCheck("read", FailureClass::unread, "a scenario that can be read", "none", why)}};
  if (isFileError) tellError(why);
  else tellInputError(why);
}

std::vector<Checked> readAll(const std::vector<std::string>& files, bool allowOutside) {
  std::vector<Checked> all;
  for (const std::string& file : files) {
    Checked& checked = all.emplace_back(Checked{file, {}});
    try {
      if (const std::string why = sharedGolden(files, file); !why.empty()) throw InputError(why);
      checked.scenario = loadScenario(file, {}, allowOutside);
    } catch (const InputError& error) { noteUnread(checked, error.what(), false); } catch (const FileError& error) {
      noteUnread(checked, error.what(), true);
    }
  }
  return all;
}

/// Reports a run that could not end: a failed check, or, if the scenario must stop, a check of the reason.
CheckReport failed(const Scenario& scenario, const Simulation& run) {
  if (!scenario.check.fails.empty()) return checkStop(scenario, run.end.failure);
  CheckResult result = failedCheck("run", FailureClass::computation, "done", name(run.end.status), run.end.failure);
  result.firstStep = run.end.steps;
  return {goldenName(scenario.file), {result}};
}

/// Runs the scenario and checks it. A result that differs is kept for a review.
CheckReport checkOne(const Scenario& scenario, const Execution& how, bool quiet) {
  std::optional<CheckedRun> checked;
  try {
    checked = simulateChecked(scenario, how, {.quiet = quiet, .record = recordingOf(scenario, true)});
  } catch (const InputError& refused) {
    if (scenario.check.fails.empty()) throw;
    return checkStop(scenario, refused.what());
  }
  const Simulation& run = checked->run;
  if (run.end.status != RunStatus::done) return failed(scenario, run);
  const GoldenData observed = observe(scenario, run);
  CheckReport report = check(scenario, *checked, observed, true);
  report.state = run.end.stateHash->text();
  if (report.passed()) removePending(scenario);
  else if (scenario.check.fails.empty()) putPending(scenario, run, observed, how, quiet);
  // Sanity and Bullet results are not reviewed: accepting a golden cannot change them.
  report.results.insert(report.results.end(), checked->sanity.begin(), checked->sanity.end());
  for (auto& result : checkAgainstBullet(scenario, run.world, quiet).results)
    report.results.push_back(std::move(result));
  return report;
}

/// Returns the names under which results are reported: "thesis/unique-four" for …/scenarios/thesis/…; the path as given
/// for a file that lies elsewhere, or whose name another file has, too.
std::vector<std::string> reportNames(const std::vector<Checked>& all) {
  std::map<std::string, int> count;
  for (const Checked& c : all) ++count[goldenName(c.file)];
  std::vector<std::string> names;
  for (const Checked& c : all) {
    const std::string name = goldenName(c.file);
    const std::filesystem::path file = std::filesystem::path(c.file).lexically_normal();
    const bool elsewhere = !liesInScenarios(c.file);
    names.push_back(!c.scenario                    ? file.generic_string()
                    : elsewhere || count[name] > 1 ? std::filesystem::path(file).replace_extension().generic_string()
                                                   : name);
  }
  return names;
}

/// Adds what `morula report` needs beyond the contract: differences in words, the scenarios' places, and their end
/// states.
void addForPage(Json& report, const std::vector<CheckReport>& reports) {
  std::size_t i = 0;
  report["changes"] = report["files"] = report["states"] = Json::object();
  for (const CheckReport& r : reports) {
    if (!r.change.empty()) report["changes"][r.scenario] = r.change;
    if (!r.file.empty()) report["files"][r.scenario] = r.file;
    if (!r.state.empty()) report["states"][r.scenario] = r.state;
    for (const CheckResult& result : r.results) report["results"][i++]["message"] = result.message;
  }
}

/// Writes report.html from report.json.
void writePage(const std::filesystem::path& folder, const Execution& how, bool quiet) {
  ReportQuestion question;
  question.what = {(folder / "report.json").string()};
  question.execution = how, question.quiet = quiet;
  findExplorer(question);
  writeFile(folder / "report.html", makeReport(question).bytes, Content::page);
}

/// Puts the names that the scenario gives its cells into a report.
CheckReport withNames(CheckReport report, const CellNames& names) {
  report.change = morula::withNames(report.change, names.function());
  for (CheckResult& r : report.results) {
    r.message = morula::withNames(r.message, names.function());
    if (r.cell) r.field += " of " + morula::withNames(cellName(*r.cell), names.function());
    r.cell.reset();
  }
  return report;
}

constexpr const char* reportFiles[] = {"junit.xml", "report.json", "summary.md", "report.html"};

/// Removes the reports of an earlier check, which must not be taken for those of this check, however it ends. Other
/// files stay.
void removeReports(const std::filesystem::path& folder) {
  makeFolder(folder);
  for (const char* name : reportFiles) {
    const auto file = folder / name;
    if (!isPlainFile(file)) continue;
    const Content content = contentOfFile(file);
    if (content == Content::report || content == Content::page) removeFile(file);
  }
}

/// `told`: the reports with names for people. `table`: the comparison with other engines, or "".
void writeReports(const std::filesystem::path& folder, const std::vector<CheckReport>& reports,
                  const std::vector<CheckReport>& told, const Json& found, const std::string& table) {
  writeFile(folder / "junit.xml", junitXml(told), Content::report);
  Json report{{"morula", 1}};
  report.update(found);
  addForPage(report, reports);
  writeFile(folder / "report.json", printable(jsonText(report, 2)) + '\n', Content::report);
  writeFile(folder / "summary.md", summaryPage(told) + (table.empty() ? "" : "\n" + printable(table)), Content::report);
}

/// Returns reports on goldens that belong to no scenario.
std::vector<CheckReport> orphans() {
  std::vector<CheckReport> reports;
  for (const auto& file : goldensWithoutScenario("golden", "scenarios")) {
    const std::string why = file.string() + ": this golden file has no scenario";
    tellError(why);
    reports.push_back({file.string(), {failedCheck("orphan", FailureClass::inputChanged, "a scenario", "none", why)}});
  }
  return reports;
}

/// Returns the exit code for the states of all results. Files that cannot be opened have the exit code of all verbs.
int exitCode(const std::vector<Checked>& all, const std::vector<CheckReport>& reports) {
  std::vector<ResultState> states;
  for (const CheckReport& r : reports) states.push_back(stateOf(r));
  const ResultState worst = worstOf(states);
  const auto isOfFiles = [](const Checked& c) { return c.scenario || c.isFileError; };
  const auto isUnread = [](const Checked& c) { return !c.scenario; };
  if (worst == ResultState::unread && std::ranges::all_of(all, isOfFiles) && std::ranges::any_of(all, isUnread))
    return file;
  return exitCodeOf(worst);
}

int act(const CheckOptions& options) {
  const auto how = execution(options.execution);
  const bool quiet = options.output.quiet;
  const ComparisonOptions beside{options.beside, options.cpuLimit, quiet};
  if (!options.reports.empty()) removeReports(options.reports);
  std::vector<CheckReport> reports, told;
  std::vector<Checked> all;
  std::string nothing;  // the reason if there is nothing to check
  try {
    all = readAll(options.scenarios.empty() ? projectScenarios(quiet) : options.scenarios, options.input.allowOutside);
  } catch (const InputError& error) {
    nothing = error.what();
    tellInputError(nothing);
    reports.push_back({"scenarios", {failedCheck("read", FailureClass::unread, "scenarios", "none", nothing)}});
    told = reports;
  }

  Json results = Json::array();
  std::vector<Verdict> own;
  std::vector<Scenario> compared;  // to be compared with other engines
  const auto names = reportNames(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    Checked& c = all[i];
    try {
      if (c.scenario) c.report = checkOne(*c.scenario, how, quiet);
    } catch (const InputError& error) { noteUnread(c, error.what(), false); } catch (const FileError& error) {
      noteUnread(c, error.what(), true);
    } catch (const NumericalError& error) {  // no memory for pictures
      c.report = {"", {failedCheck("run", FailureClass::computation, "done", "failed", error.what())}};
    }
    c.report.scenario = c.scenario ? names[i] : c.file;
    if (c.scenario) c.report.file = c.file;
    const CellNames cells = c.scenario ? c.scenario->names : CellNames{};
    const std::string words = morula::withNames(describe(c.report), cells.function());
    if (!c.scenario) {  // reported on stderr
    } else if (!options.output.json && beside.engines.empty()) print(words);
    else if (!c.report.passed()) tell(words, quiet);
    reports.push_back(c.report), told.push_back(withNames(c.report, cells));
    if (!beside.engines.empty() && c.scenario)
      own.push_back(judge(c.scenario->check, c.report)), compared.push_back(*c.scenario);
  }
  if (options.scenarios.empty())
    for (const CheckReport& orphan : orphans()) reports.push_back(orphan), told.push_back(orphan);
  for (const CheckReport& report : reports)
    for (const CheckResult& result : report.results) results.push_back(toJson(report, result));
  Json found{{"results", results}};
  std::string table;
  if (!beside.engines.empty()) {
    const auto rows = compareEngines(compared, own, beside);
    found["beside"] = toJson(rows, beside.engines);
    table = comparisonTable(rows, beside.engines);
  }
  if (options.output.json) printJson(found);
  else if (!table.empty()) print(table);
  if (!options.reports.empty()) writeReports(options.reports, reports, told, found, table);
  tellWorkflow(told, options.output.json);
  if (!options.reports.empty()) writePage(options.reports, how, quiet);
  return exitCode(all, reports);
}

}  // namespace

void addCheck(CLI::App& app, Action& action) {
  Verb verb(app, action, "check", "Run scenarios again and compare them with their golden files");
  auto& options = verb.does<CheckOptions>(act);
  verb.takes("scenario", options.scenarios, "FILE", "Scenario files; default: all under scenarios/");
  verb.takes("--reports", options.reports, "FOLDER",
             "Folder for junit.xml, report.json, summary.md and the page report.html");
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
