// A check of many scenarios: the differing scenarios and their differences.
#include <algorithm>

#include "base/error.h"
#include "base/number_text.h"
#include "check/check_run.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "golden/change.h"
#include "pictures/pictures.h"
#include "report/page_parts.h"
#include "report/run_blocks.h"
#include "system/installation.h"
#include "system/json_record.h"

namespace morula {
namespace {

constexpr std::size_t maxTold = 40;   // max number of failed scenarios with all differences
constexpr std::size_t maxFiles = 40;  // max number of files in the command that checks them again

std::size_t failures(const CheckReport& report) {
  return static_cast<std::size_t>(
      std::count_if(report.results.begin(), report.results.end(), [](const CheckResult& r) { return !r.passed; }));
}

/// Describes the differences: each class once, causes before their consequences.
std::string classesOf(const CheckReport& report) {
  std::vector<std::string> classes;
  for (const CheckResult& r : report.results)
    if (const std::string words = failedInWords(r);
        !r.passed && std::find(classes.begin(), classes.end(), words) == classes.end())
      classes.push_back(words);
  return listed(classes);
}

/// Returns the largest share of a tolerance that a check of the scenario has used.
std::optional<double> largestShare(const CheckReport& report) {
  std::optional<double> largest;
  for (const CheckResult& r : report.results)
    if (r.share) largest = std::max(largest.value_or(0), *r.share);
  return largest;
}

Table overview(const std::vector<CheckedScenario>& checked) {
  Table table{"Scenarios", {"Scenario", "Checks", "What differs", "Largest share of a tolerance"}};
  for (const bool wantFailed : {true, false})
    for (const CheckedScenario& c : checked) {
      const std::size_t failed = failures(c.report);
      const std::string all = std::to_string(c.report.results.size());
      if ((failed > 0) == wantFailed)
        table.rows.push_back(
            {c.report.scenario,
             mark(failed == 0, "all " + all + " pass", std::to_string(failed) + " of " + all + " differ"),
             classesOf(c.report), shareText(largestShare(c.report))});
    }
  return table;
}

Document bodyOf(const CheckedScenario& c) {
  Document body;
  const CellNames names = c.again ? c.again->scenario.names : CellNames{};
  if (!c.report.change.empty()) body.add(changeTable(c.report.change, names));
  if (c.again && c.again->beside) body.add(goldenPictures(*c.again->beside, c.report.scenario));
  else if (c.again && c.again->simulation.world.bodies && c.again->simulation.end.status == RunStatus::done)
    body.add(Group{Group::Kind::pictures, "",
                   Document().add(pngPicture(drawOrganism(pictureOf(c.again->simulation.world, c.again->scenario)),
                                             c.report.scenario + ": the organism as it is now",
                                             "as it is now, at time " + shownTime(c.again->scenario.units,
                                                                                  c.again->simulation.end.time, 6)))});
  if (c.isOtherNow)
    body.say(
        "There are no pictures, because the scenario, its golden or the program has changed since this check; run "
        "morula check again.");
  return body.add(checksOf(c.report.results, names));
}

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw InputError(file + ": " + why + "; needs the report.json that morula check --reports has written");
}

}  // namespace

std::vector<CheckedScenario> readChecked(const std::string& file) {
  const Json json = tryParseJson(readFile(file));
  if (!json.is_object() || !json.contains("results")) refuse(file, "no results of a check");
  std::vector<CheckedScenario> checked;
  std::map<std::string, std::size_t> places;
  try {
    for (const Json& result : json.at("results")) {
      const auto name = result.at("scenario").get<std::string>();
      const auto [place, isNew] = places.emplace(name, checked.size());
      if (isNew) {
        CheckedScenario next;
        next.report.scenario = name;
        if (json.contains("changes") && json["changes"].contains(name))
          next.report.change = json["changes"][name].get<std::string>();
        if (json.contains("states") && json["states"].contains(name))
          next.report.state = json["states"][name].get<std::string>();
        if (json.contains("files") && json["files"].contains(name)) next.file = json["files"][name].get<std::string>();
        checked.push_back(std::move(next));
      }
      Json whole = result;
      if (!whole.contains("message")) whole["message"] = "";
      checked[place->second].report.results.push_back(fromJson<CheckResult>(whole));
    }
  } catch (const Json::exception&) { refuse(file, "results that are none of a check"); }
  return checked;
}

void runCheckedAgain(CheckedScenario& c, const ReportQuestion& question) {
  if (c.again || c.file.empty() || !fileExists(c.file)) return;
  try {
    Scenario scenario = loadScenario(c.file);
    World world = makeScenarioWorld(scenario, question.execution);
    // The end of a run may be unknown: then frames are spread over the longest possible time.
    const auto end = plannedEnd(scenario.scene);
    if (!end) return;
    FrameTaker taker(*end, question.frames, ForceMeter(makeScenarioWorld(scenario, question.execution)));
    auto run = simulate(scenario, std::move(world), {.quiet = question.quiet, .watch = {&taker}});
    // Words of then do not go with pictures of now.
    if ((run.end.stateHash ? run.end.stateHash->text() : "") != c.report.state) {
      c.isOtherNow = true;
      return;
    }
    c.again =
        std::make_unique<FailedAgain>(FailedAgain{std::move(scenario), std::move(run), std::move(taker.frames())});
  } catch (const InputError&) {  // the scenario has become unreadable, which the check tells
  }
}

namespace {

/// Returns true if the present golden has the end state that the check found to differ.
bool wasAcceptedSince(const CheckedScenario& c) {
  const auto failed = [](const CheckResult& r) { return r.check == "bits" && !r.passed; };
  const auto golden = goldenFile(c.again->scenario);
  if (std::ranges::none_of(c.report.results, failed) || !fileExists(golden)) return false;
  try {
    return acceptedBits(readGoldenFile(golden)) == c.report.state;
  } catch (const InputError&) { return false; }
}

}  // namespace

void runFailedAgain(std::vector<CheckedScenario>& checked, std::size_t most, const ReportQuestion& question) {
  for (CheckedScenario& c : checked) {
    if (most == 0) break;
    if (failures(c.report) == 0) continue;
    runCheckedAgain(c, question);
    if (!c.again) continue;
    --most;
    const Simulation& run = c.again->simulation;
    if (run.end.status != RunStatus::done) continue;
    if (wasAcceptedSince(c)) {
      c.again.reset(), c.isOtherNow = true;
      continue;
    }
    c.again->beside = drawBesideGoldenFile(c.again->scenario, run.world, question.execution, question.quiet);
  }
}

PagePart checkPart(const std::vector<CheckedScenario>& checked, const std::string& file) {
  std::vector<Finding> findings;
  std::size_t failed = 0, told = 0;
  PagePart part{.title = "morula check", .summary = {}};
  for (const CheckedScenario& c : checked) {
    const std::size_t differ = failures(c.report);
    if (differ == 0) continue;
    ++failed;
    const CellNames names = c.again ? c.again->scenario.names : CellNames{};
    findings.push_back(
        {Finding::Kind::bad,
         bold(c.report.scenario) + ": " + std::to_string(differ) + " of " + counted(c.report.results.size(), "check") +
             (differ == 1 ? " differs: " : " differ: ") + classesOf(c.report) +
             (c.report.change.empty()
                  ? Words()
                  : ". " + Words(changeSentence(withNames(c.report.change, names.function())), Emphasis::italic))});
    if (++told > maxTold) continue;
    part.sections.push_back({"check-" + std::to_string(told), c.report.scenario, bodyOf(c)});
    if (!c.file.empty())
      part.sections.back().commands = {programWord() + " check " + shellWord(c.file),
                                       programWord() + " explain " + shellWord(c.file),
                                       programWord() + " review " + shellWord(c.file)};
  }
  part.title =
      failed ? "morula check: " + std::to_string(failed) + " of " + counted(checked.size(), "scenario") +
                   (failed == 1 ? " differs" : " differ")
             : "morula check: " + counted(checked.size(), "scenario") + (checked.size() == 1 ? " passes" : " pass");
  if (!failed) findings.push_back({Finding::Kind::good, "Every scenario gives its accepted result"});
  if (told > maxTold)
    findings.push_back(
        {Finding::Kind::warning, "Differences are shown for the first " + std::to_string(maxTold) + " scenarios"});
  part.verdict = verdict(std::to_string(checked.size() - failed) + " of " + counted(checked.size(), "scenario") +
                             (checked.size() == 1 ? " passes" : " pass") + ".",
                         std::move(findings));
  std::string files;
  for (const CheckedScenario& c : checked)
    if (!c.file.empty()) files += ' ' + shellWord(c.file);
  // Without files the command checks all scenarios of the project.
  if (checked.size() > maxFiles) files.clear();
  const std::string folder = std::filesystem::path(file).parent_path().generic_string();
  part.sections.push_back(
      {"checks",
       "Scenarios",
       Document().add(overview(checked)),
       {programWord() + " check" + files + " --reports " + shellWord(folder.empty() ? "." : folder)}});
  return part;
}

}  // namespace morula
