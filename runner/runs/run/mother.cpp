#include "run/mother.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/error.h"
#include "files/text.h"
#include "loop/scenario_run.h"
#include "loop/stored_scenario.h"
#include "simulation/restore.h"
#include "simulation/run_end.h"
#include "simulation/settle.h"
#include "state/experiment.h"
#include "system/json.h"
#include "system/usage_error.h"
#include "yaml/numbers.h"

namespace morula {
namespace {

Json valuesOf(const RunRecord& record) {
  for (const SourceText& d : record.documents)
    if (d.role == "resolved")
      if (Json json = tryParseJson(d.content); json.is_object()) return json;
  return Json::object();
}

std::string keysThatDiffer(const Json& there, const Json& here) {
  const Json before = there.flatten(), now = here.flatten();
  std::set<std::string> keys;
  for (const Json* values : {&before, &now})
    for (const auto& [key, value] : values->items()) keys.insert(key);
  const auto text = [](const Json& values, const std::string& key) {
    return values.contains(key) ? jsonText(values[key]) : std::string("nothing");
  };
  std::string found;
  for (const std::string& key : keys) {
    if (text(before, key) == text(now, key)) continue;
    std::string path = key.empty() ? key : key.substr(1);
    std::ranges::replace(path, '/', '.');
    found += (found.empty() ? "" : "; ") + path + ": " + text(before, key) + " then, " + text(now, key) + " now";
  }
  return found;
}

Json experimentsOf(const Json& values) { return values.value("experiments", Json::array()); }

/// Returns how many experiments `now` has after those of `before`; absent, with the keys in `why`, if the two differ in
/// more than these and a stop whose conditions are the same or removed.
std::optional<std::size_t> addedExperiments(Json before, Json now, std::string& why) {
  const Json earlier = experimentsOf(before), later = experimentsOf(now);
  if (earlier.size() <= later.size() && std::equal(earlier.begin(), earlier.end(), later.begin()))
    before.erase("experiments"), now.erase("experiments");
  Json& stop = now["stop"];
  for (const char* key : {"time", "cycles", "cells"}) before["stop"].erase(key), stop.erase(key);
  if (!stop.contains("when"))
    for (const char* key : {"when", "every"}) before["stop"].erase(key), stop.erase(key);
  for (Json* values : {&before, &now})
    if ((*values)["stop"].empty()) values->erase("stop");
  why = keysThatDiffer(before, now);
  return why.empty() ? std::optional(later.size() - earlier.size()) : std::nullopt;
}

constexpr const char* withoutCheckpoint =
    "keeps no state to go on from, as runs of a study, of an exported file or of an older program do, and runs in "
    "which all cells died or that are larger than 256 MB; run its scenario with the changes, from its start";

[[noreturn]] void refuseKey(const Override& change) {
  std::vector<std::string> keys;
  for (const ChangeableParameter& p : changeableParameters) keys.emplace_back(p.path);
  throw UsageError(change.place + ": " + change.path +
                   " decides a run from its start, and cannot change when the run goes on; these can: stop.time, "
                   "stop.cycles, stop.cells, " +
                   join(keys) + ", and experiments, by further ones; or run the scenario from its start");
}

/// Returns the time [time] of the first experiment that a run which was stopped can go on with.
double nextTime(Store& store, const StoredRun& run, const Scenario& scenario, const Execution& execution) {
  const auto checkpoint = store.checkpointOf(run.id);
  if (!checkpoint) throw UsageError("--resume: run " + run.id + " " + withoutCheckpoint);
  World world = makeScenarioWorld(scenario, execution);
  restoreState(world, checkpoint->state);
  const Clock& clock = world.clock;
  return world.bodies && !settles(world) ? timeAfter(clock, 1)
                                         : std::max(clock.nextCycle, std::nextafter(clock.time, INFINITY));
}

}  // namespace

std::string keysThatDiffer(const RunRecord& there, const RunRecord& here) {
  return keysThatDiffer(valuesOf(there), valuesOf(here));
}

std::optional<Mother> findMother(Store& store, const RunRecord& record, const std::string& id, std::string& why) {
  const Json now = valuesOf(record);
  std::optional<Mother> found;
  for (const StoredRun& run : store.runs()) {
    const RunRecord& there = run.record;
    if (id.empty() ? there.scenario != record.scenario || run.id == runId(record) : run.id != id) continue;
    std::string other;
    if (buildId(there.build) != buildId(record.build)) other = "was computed by another program";
    RunRecord whole = there;
    whole.documents = store.documents(run.id);
    const Json before = valuesOf(whole);
    std::string keys;
    const auto added = addedExperiments(before, now, keys);
    if (!added)
      other = "cannot go on so (" + keys + "); its stop can be later, and further experiments can follow its own";
    auto checkpoint = other.empty() ? store.checkpointOf(run.id) : std::nullopt;
    if (other.empty() && !checkpoint) other = withoutCheckpoint;
    if (!id.empty() && !other.empty()) why = "run " + run.id + " " + other;
    if (!other.empty() || (found && found->checkpoint.step > checkpoint->step)) continue;
    found = Mother{run, std::move(*checkpoint), *added, *added > 0 && experimentsOf(before).empty()};
  }
  return found;
}

double timeOfGoingOn(const StoredRun& run, const Scene& scene) {
  const auto end = plannedEnd(scene);
  const bool others = !scene.stop.when.empty() || (scene.stop.cells && run.cells >= *scene.stop.cells);
  return end && !others ? *end : run.time;
}

Scenario scenarioGoingOn(Store& store, const StoredRun& run, const std::vector<Override>& changes,
                         const Execution& execution) {
  const std::string file = store.file().string();
  const Scenario before = storedScenario(file, run.id);
  const bool hasEnded = run.status == RunStatus::done;
  if (run.status == RunStatus::failed && !store.checkpointOf(run.id))
    throw UsageError("--resume: run " + run.id + " failed and cannot go on; morula explain tells why");
  std::vector<Override> list;
  std::string entries, place;
  std::optional<double> time;
  for (const Override& change : changes) {
    if (change.path == "stop" || change.path.starts_with("stop.") || change.path == "experiments") {
      list.push_back(change);
      continue;
    }
    if (!changeableParameter(change.path)) refuseKey(change);
    if (const auto number = scenario::parseReal(change.value); !number.wrong.empty())
      throw InputError(change.place + ": '" + change.value + "' " + number.wrong + "; needs a number, as " +
                       change.path + "=5");
    if (!time) time = hasEnded ? timeOfGoingOn(run, before.scene) : nextTime(store, run, before, execution);
    entries += (entries.empty() ? "" : ", ") + ("{set: " + change.path + ", to: " + change.value) +
               ", at: " + exactText(*time) + "}";
    place = change.place;
  }
  if (!entries.empty()) {
    std::string all;
    for (const Json& entry : experimentsOf(tryParseJson(before.resolved))) all += jsonText(entry) + ", ";
    list.push_back({"experiments", "[" + all + entries + "]", place});
  }
  Scenario now = storedScenario(file, run.id, list);
  const auto& stop = before.scene.stop;
  const bool endsLater = now.scene.stop.cells != stop.cells || plannedEnd(now.scene) != plannedEnd(before.scene) ||
                         now.scene.stop.when.size() != stop.when.size();
  const std::string later = "give a later stop, as --set stop.time=" + numberText(2 * run.time, 6);
  if (hasEnded && now.meaning == before.meaning)
    throw UsageError("--resume: run " + run.id + " has ended, at time " + numberText(run.time, 6) + "; " + later +
                     ", and what is to change then, if anything, as --set physics.drag=5");
  if (hasEnded && !endsLater) now.warnings.push_back(file + ": the run ends when the other one did; " + later);
  return now;
}

}  // namespace morula
