// The report of a run, for people and as JSON.
#include <fmt/format.h>

#include "check/against.h"
#include "check/check_run.h"
#include "document/words.h"
#include "engines/bullet_check.h"
#include "files/folders.h"
#include "run/run_scenario.h"
#include "values/measure_list.h"

namespace morula {
namespace {

std::string against(const Scenario& scenario) {
  const auto golden = goldenFile(scenario);
  return fileExists(golden) ? " (" + golden.string() + ")" : "";
}

/// Describes ambiguous divisions. They are no failure: the same program always cuts the same way. A program that
/// differs a little may cut another way.
std::string describeAmbiguous(const std::vector<DivisionRecord>& divisions, const Units& units) {
  if (divisions.empty()) return "";
  const DivisionRecord& first = divisions.front();
  return fmt::format(
      "  warning  {} by longest of cells whose two largest extents are equal (to {:.2g} %), first {} at time {}; "
      "another mesh or time step may cut elsewhere\n",
      counted(divisions.size(), "division"), 100 * (ambiguousExtentRatio - 1), cellName(first.path.text()),
      shownTime(units, first.time));
}

Json ambiguousToJson(const std::vector<DivisionRecord>& divisions) {
  Json list = Json::array();
  for (const DivisionRecord& d : divisions)
    list.push_back({{"path", d.path.text()}, {"time", d.time}, {"extent_ratio", *d.extentRatio}});
  return list;
}

std::string describeSanity(const RunOutcome& outcome, const Scenario& scenario) {
  if (!outcome.isSane()) return "";
  if (!scenario.check.sane) return "  sane     need not be: " + scenario.check.because + "\n";
  return *outcome.isSane() ? "  sane     yes\n" : "";
}

Json sanityJson(const std::vector<CheckResult>& results) {
  Json list = Json::array();
  for (const CheckResult& r : results)
    list.push_back({{"check", r.check},
                    {"passed", r.passed},
                    {"cell", orNull(r.cell)},
                    {"expected", r.expected},
                    {"actual", r.actual},
                    {"message", r.message}});
  return list;
}

/// Writes the last rows of the tables sample, cell_sample and measure as JSON.
Json sampleJson(const Sample& sample) {
  Json json{{"time", sample.world.time}};
  addMeasures(json, sample.world);
  json["cell_sample"] = Json::array();
  for (const CellMeasures& c : sample.cells) {
    Json cell{{"path", c.path.text()}};
    addMeasures(cell, c);
    json["cell_sample"].push_back(std::move(cell));
  }
  json["measure"] = Json::array();
  for (const TakenMeasure& m : sample.more)
    json["measure"].push_back({{"scope", name(m.scope)},
                               {"name", m.name},
                               {"a", m.scope == Scope::world ? Json() : Json(m.a.text())},
                               {"b", m.scope == Scope::pair ? Json(m.b.text()) : Json()},
                               {"value", m.value}});
  return json;
}

}  // namespace

std::string describe(const RunOutcome& outcome, const Scenario& scenario, const RunSettings& settings) {
  const auto& end = outcome.end;
  auto text =
      fmt::format("{}  seed {}: {}, {} at time {} after {} steps\n", scenario.scene.name, scenario.scene.seed,
                  name(end.status), counted(end.cells, "cell"), shownTime(scenario.units, end.time, 6), end.steps);
  if (outcome.resumedAt)
    text += fmt::format("  resumed  at step {}{}\n", *outcome.resumedAt,
                        outcome.mother.empty() ? "" : " of run " + outcome.mother);
  if (outcome.canBeResumed) text += "  continue with the same command and --resume\n";
  if (end.stateHash) text += "  state    " + end.stateHash->text() + "\n";
  if (outcome.checks && outcome.checks->passed()) {
    std::size_t looked = 0;
    for (const CheckResult& r : outcome.checks->results) {
      if (wasSkipped(r)) text += "  bullet   " + r.actual + "\n";
      else if (!wasCompared(r)) text += (r.check == "images" ? "  picture  " : "  golden   ") + r.actual + "\n";
      else ++looked;
    }
    if (looked) text += fmt::format("  checks   all {} pass{}\n", looked, against(scenario));
  } else if (!outcome.checks && end.status == RunStatus::done)
    text += "  checks   none: " + outcome.whyNotChecked + "\n";
  if (!outcome.stopped.empty()) text += "  stopped  stop.when: " + outcome.stopped + " holds\n";
  for (const std::string& line : outcome.experiments) text += "  done     " + line + "\n";
  text += describeAmbiguous(outcome.ambiguous, scenario.units);
  if (!outcome.settled.empty()) text += "  settled  " + outcome.settled + "\n";
  if (!outcome.unsettled.empty()) text += "  warning  " + outcome.unsettled + "\n";
  if (!outcome.reference.empty()) text += "  warning  " + outcome.reference + "\n";
  for (const std::string& remark : againstRemarks(outcome.against, scenario.units))
    text += "  warning  " + remark + "\n";
  text += describeSanity(outcome, scenario);
  text += "  results  " + outcome.database.string() + " (run " + outcome.id + ")\n";
  std::size_t frames = 0;
  for (const auto& file : outcome.pictures) {
    if (file.find("/sequence/") != file.npos) ++frames;
    else text += "           " + file + "\n";
  }
  if (frames) text += fmt::format("           {} ({} pictures)\n", (settings.folder / "sequence").string(), frames);
  if (outcome.checks && !outcome.checks->passed()) text += describe(*outcome.checks);
  if (!outcome.isSane().value_or(true)) text += describe(outcome.sanityReport(scenario));
  if (!outcome.against.empty()) text += textOf(againstTable(outcome.against, scenario));
  return withNames(text, scenario.names.function());
}

Json toJson(const RunOutcome& outcome, const Scenario& scenario) {
  const auto& end = outcome.end;
  Json json{{"run_id", outcome.id},
            {"scenario", scenario.scene.name},
            {"seed", scenario.scene.seed},
            {"seed_matters", usesSeed(scenario.scene)},
            {"status", name(end.status)},
            {"state_hash", end.stateHash ? Json(end.stateHash->text()) : Json()},
            {"steps", end.steps},
            {"cells", end.cells},
            {"time", end.time},
            {"units", knownUnits(scenario.units)},
            {"resumed_at", orNull(outcome.resumedAt)},
            {"mother_run_id", outcome.mother.empty() ? Json() : Json(outcome.mother)},
            {"db", outcome.database.string()},
            {"pictures", outcome.pictures},
            {"ambiguous_divisions", ambiguousToJson(outcome.ambiguous)},
            {"stopped", outcome.stopped},
            {"experiments", outcome.experiments},
            {"settled", outcome.settled},
            {"unsettled", outcome.unsettled},
            {"reference", outcome.reference},
            {"checked", outcome.checks ? Json(outcome.checks->passed()) : Json()},
            {"state", nameOf(outcome.state())},
            {"sane", orNull(outcome.isSane())},
            {"sanity", sanityJson(outcome.sanity)}};
  if (outcome.last) json["sample"] = sampleJson(*outcome.last);
  if (!outcome.against.empty())
    json["against"] = {{"stages", againstJson(outcome.against, scenario)},
                       {"remarks", againstRemarks(outcome.against, scenario.units)}};
  if (!end.failure.empty()) json["failure"] = end.failure;
  return json;
}

}  // namespace morula
