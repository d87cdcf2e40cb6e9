#include "export/surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/number_text.h"
#include "database/store_error.h"
#include "drawing/palette.h"
#include "loop/simulate.h"
#include "loop/stored_scenario.h"
#include "pictures/pictures.h"
#include "system/console.h"
#include "system/usage_error.h"

namespace morula {
namespace {

constexpr double rounding = 1e-9;  // [1] relative tolerance for times that people type

/// Returns the time step with which the run reached `time` [time].
double stepBefore(const RunResults& results, double time) {
  double step = 0;
  for (const TimeStepRecord& t : results.timeSteps)
    if (step == 0 || t.time < time) step = t.timeStep;
  return step;
}

/// Returns true if the sample was taken at the first step at or after `time`.
bool isAt(const Sample& sample, double time, const RunResults& results) {
  const double t = sample.world.time;
  return std::abs(t - time) <= rounding * time || (t >= time && t - time < stepBefore(results, t));
}

/// Returns the times with surfaces: "0, 0.5 and 7 more"; "" for none.
std::string keptTimes(const std::vector<Sample>& samples) {
  std::string text;
  std::size_t count = 0;
  for (const Sample& s : samples) {
    if (s.surfaces.empty()) continue;
    if (++count <= 8) text += (text.empty() ? "" : ", ") + exactText(s.world.time);
  }
  return count > 8 ? text + fmt::format(" and {} more", count - 8) : text;
}

double timeWithin(double time, const StoredRun& run) {
  if (time <= run.time) return time;
  if (time <= run.time * (1 + rounding)) return run.time;
  throw UsageError(fmt::format("--time: {} is after the end of run {}; needs at most {}", exactText(time), run.id,
                               exactText(run.time)));
}

/// Returns the times [time] for which surfaces are wanted and not kept; wanted and kept surfaces stay in `results`.
std::vector<double> missingTimes(RunResults& results, const StoredRun& run, const SurfaceRequest& request) {
  auto& samples = results.samples;
  const bool any = std::ranges::any_of(samples, [](const Sample& s) { return !s.surfaces.empty(); });
  if (!request.time && !request.atEnd) {
    if (any) return {};
    std::vector<double> times;
    for (const Sample& s : samples) times.push_back(s.world.time);
    return times;
  }
  const double time = request.time ? timeWithin(*request.time, run) : run.time;
  const auto found =
      std::ranges::find_if(samples, [&](const Sample& s) { return !s.surfaces.empty() && isAt(s, time, results); });
  if (found == samples.end()) return {time};
  samples = {std::move(*found)};
  return {};
}

/// Throws unless the end is the stored one; otherwise the samples before it belong to another computation.
void requireSameEnd(const Store& store, const StoredRun& run, const RunEnd& end) {
  const std::string now = end.status == RunStatus::done ? end.stateHash->text() : "failed: " + end.failure;
  if (now == run.stateHash) return;
  const std::string what = fmt::format("{}: run {}, simulated again, ends in another state: stored {}, now {}",
                                       store.file().string(), run.id, run.stateHash, now);
  if (buildId(run.record.build) == buildId(buildInfo()))
    throw NondeterminismError(what + "; nothing is exported. `morula replay` lists the differences", run.id,
                              run.stateHash, now);
  throw FileError(what + "; another build made the run (" + run.record.build.version +
                  "), which can export it; `morula replay` lists the differences");
}

/// Samples and surfaces at these times, rising, from running it once more.
void simulateAgain(const Store& store, const StoredRun& run, const Scenario& scenario, std::vector<double> times,
                   const SurfaceRequest& request, RunResults& results) {
  if (run.status != RunStatus::done)
    throw FileError(
        fmt::format("{}: run {} did not come to its end ({}), so surfaces that it did not keep cannot be computed; "
                    "give a time with kept surfaces: {}",
                    store.file().string(), run.id, name(run.status),
                    keptTimes(results.samples).empty() ? "none" : keptTimes(results.samples)));
  const std::string kept = keptTimes(results.samples);
  tell(fmt::format("run {} kept {}; simulating it again to its end at {}", run.id,
                   kept.empty() ? "no surfaces (record.meshes keeps them)" : "surfaces at " + kept + " alone",
                   exactText(run.time)),
       request.quiet);
  auto again =
      simulate(scenario, request.execution, {.quiet = request.quiet, .record = {.meshesAt = std::move(times)}});
  requireEnough(again.end);
  requireSameEnd(store, run, again.end);
  tell("the end equals the stored one, bit for bit", request.quiet);
  results = std::move(again.results);
}

}  // namespace

Colour ExportedRun::colourOf(const CellPath& cell, StateId state) const {
  const auto found = own.find(cell);
  return found == own.end() ? colours.at(state) : found->second;
}

int ExportedRun::cellNumber(const CellPath& path) const {
  const auto found = std::ranges::lower_bound(results.lineage, path, {}, &LineageEntry::path);
  if (found == results.lineage.end() || found->path != path) return -1;
  return static_cast<int>(found - results.lineage.begin());
}

std::string ExportedRun::nameOf(const LineageEntry& cell) const {
  if (const auto named = results.names.find(cell.path); named != results.names.end()) return named->second;
  const std::string path = cell.path.isEgg() ? "egg" : cell.path.text();
  return givenNames.contains(path) ? '/' + path : path;
}

const MeshFaces& ExportedRun::meshOf(const CellSurface& surface) const {
  const auto found = std::ranges::find(results.meshes, surface.mesh, &MeshFaces::mesh);
  MORULA_CHECK(found != results.meshes.end(), "each surface has faces");
  return *found;
}

const CellMeasures* ExportedRun::measuresOf(const Sample& sample, const CellPath& path) {
  const auto found = std::ranges::lower_bound(sample.cells, path, {}, &CellMeasures::path);
  return found == sample.cells.end() || found->path != path ? nullptr : &*found;
}

int ExportedRun::stateNumber(StateId state) const {
  return static_cast<int>(std::ranges::lower_bound(states, results.stateTexts.at(state)) - states.begin());
}

ExportedRun exportedRun(Store& store, const StoredRun& run, const SurfaceRequest& request) {
  ExportedRun out{.run = run};
  const bool tree = request.wanted == Wanted::tree, measures = request.wanted == Wanted::measures;
  out.results = tree ? store.lineage(run.id) : measures ? store.measured(run.id) : store.results(run.id);
  const Scenario scenario = storedScenario(store.file().string(), run.id);
  out.units = scenario.units;
  const bool bodies = out.hasBodies = scenario.scene.mechanics.has_value();
  if (request.wanted == Wanted::surfaces && !bodies)
    throw UsageError(fmt::format("--format: run {} of {} has no bodies, and so no surfaces; needs csv, newick or npz",
                                 run.id, run.record.scenario));
  auto times = bodies && !tree && !measures ? missingTimes(out.results, run, request) : std::vector<double>();
  const bool canDoWithout = request.wanted == Wanted::samples && !request.time && run.status != RunStatus::done;
  if (!times.empty() && canDoWithout)
    tell(fmt::format("run {} did not come to its end ({}), so there are no surfaces of it", run.id, name(run.status)),
         request.quiet);
  else if (!times.empty()) simulateAgain(store, run, scenario, std::move(times), request, out.results);
  auto& samples = out.results.samples;
  if ((!bodies || measures) && request.time) {  // without surfaces: the first sample at or after the time
    const double time = timeWithin(*request.time, run);
    const auto found = std::ranges::find_if(samples, [&](const Sample& s) { return s.world.time >= time; });
    if (found != samples.end()) samples = {std::move(*found)};
  }
  const bool oneTime = request.time || request.atEnd;
  const bool any = std::ranges::any_of(samples, [](const Sample& s) { return !s.surfaces.empty(); });
  // After the last cell has died a series continues without surfaces.
  if (bodies && !measures && (request.wanted == Wanted::surfaces || request.time))
    std::erase_if(samples, [&](const Sample& s) { return s.surfaces.empty() && (oneTime || !s.cells.empty()); });
  if (request.wanted == Wanted::surfaces && !any)
    throw UsageError(fmt::format("--format: run {} of {} has no living cell {}, and so no surfaces", run.id,
                                 run.record.scenario, request.time ? "then" : "at its end"));
  std::ranges::sort(out.results.lineage, {}, &LineageEntry::path);
  for (const auto& [path, name] : out.results.names) out.givenNames.insert(name);
  Palette palette(scenario);
  std::set<std::string> texts;
  for (const auto& [state, text] : out.results.stateTexts)
    out.colours[state] = palette.colourOf(text), texts.insert(text);
  for (const LineageEntry& cell : out.results.lineage)
    if (const CellColour* own = cellColourOf(scenario, cell.path)) out.own[cell.path] = parseColour(own->colour);
  out.states.assign(texts.begin(), texts.end());
  return out;
}

}  // namespace morula
