#include "library/morula.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/floating_point.h"
#include "library/scene_format.h"
#include "library/table.h"
#include "library/world_tables.h"
#include "observation/asked_measure.h"
#include "simulation/restore.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"

namespace morula {

struct Simulator::State {
  explicit State(World made) : world(std::move(made)) {}
  World world;
  // Measured on request, and kept until the next step
  mutable std::optional<Observation> observation;
  mutable std::optional<std::vector<CellMeasures>> measured;

  const Observation& now() const { return observation ? *observation : observation.emplace(world); }
  const std::vector<CellMeasures>& cells() const {
    return measured ? *measured : measured.emplace(measureCells(now()));
  }
  World& change() {
    measured.reset(), observation.reset();
    return world;
  }
};

namespace {

template <class Of>
bool isSampled(std::string_view name) {
  const auto rows = sampledMeasures<Of>();
  return std::any_of(rows.begin(), rows.end(), [&](const Measure<Of>& row) { return row.name == name; });
}

void requireOnDemand(std::string_view name, Scope scope) {
  const auto all = measuresOnDemand();
  if (std::none_of(all.begin(), all.end(),
                   [&](const MeasureOnDemand& m) { return m.name == name && m.scope == scope; }))
    throw InputError("there is no measure '" + std::string(name) + "' of " +
                     (scope == Scope::world ? "the organism" : "cells") + "; morula schema --measures lists them");
}

World makeFrom(std::string_view scene, int threads) {
  const FloatingPointMode mode;
  Execution execution;
  execution.threads = threads;
  return makeWorld(readScene(scene, "scene"), execution);
}

const CellPath& pathOf(const World& world, std::size_t cell) {
  if (cell >= world.cells.path.size())
    throw InputError("there is no cell " + std::to_string(cell) + "; " + std::to_string(world.cells.path.size()) +
                     " are alive");
  return world.cells.path[cell];
}

}  // namespace

Simulator::Simulator(std::string_view scene, int threads) : state_(new State(makeFrom(scene, threads))) {}
Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

void Simulator::step(std::uint64_t most) {
  const FloatingPointMode mode;
  World& world = state_->change();
  const std::uint64_t end = world.clock.step + most;
  while (world.clock.step < end && !morula::finished(world)) takeSteps(world, end - world.clock.step);
}

void Simulator::runUntil(double time) {
  while (now() < time && !finished()) step(stepsUntil(state_->world.clock, time));
}

bool Simulator::finished() const { return morula::finished(state_->world); }
std::uint64_t Simulator::steps() const { return state_->world.clock.step; }
double Simulator::now() const { return state_->world.clock.time; }
std::optional<double> Simulator::end() const { return plannedEnd(state_->world.model); }
std::string Simulator::hash() const { return stateHash(state_->world).text(); }
std::string Simulator::save() const { return saveState(state_->world); }

void Simulator::restore(std::string_view state) {
  const FloatingPointMode mode;
  World fresh = makeWorld(state_->world.model, state_->world.execution);
  restoreState(fresh, state);
  state_->change() = std::move(fresh);
}

std::size_t Simulator::cells() const { return state_->world.cells.path.size(); }
std::string Simulator::path(std::size_t cell) const { return pathOf(state_->world, cell).text(); }

std::string Simulator::substances(std::size_t cell) const {
  pathOf(state_->world, cell);
  return state_->world.biology->describe(state_->world.cells.state[cell]);
}

std::vector<double> Simulator::vertices(std::size_t cell) const {
  std::vector<double> all;
  for (const Point& p : cellVertices(state_->world, pathOf(state_->world, cell)))
    all.insert(all.end(), {p.x, p.y, p.z});
  return all;
}

std::vector<std::int32_t> Simulator::faces(std::size_t cell) const {
  std::vector<std::int32_t> all;
  for (const Face& face : cellMesh(state_->world, pathOf(state_->world, cell)).faces)
    all.insert(all.end(), face.begin(), face.end());
  return all;
}

DataTable Simulator::table(std::string_view name) const {
  const FloatingPointMode mode;
  return worldTable(state_->now(), name, {});
}

std::optional<double> Simulator::measure(std::string_view name) const {
  const FloatingPointMode mode;
  if (isSampled<Observation>(name)) return measureWorld(state_->now())[name];
  requireOnDemand(name, Scope::world);
  const auto taken = takeMeasures(state_->now(), std::vector{std::string(name)});
  return taken.empty() ? std::nullopt : std::optional(taken.front().value);
}

std::optional<double> Simulator::measure(std::string_view name, std::size_t cell) const {
  pathOf(state_->world, cell);
  const double value = column(name)[cell];
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

std::vector<double> Simulator::column(std::string_view name) const {
  const FloatingPointMode mode;
  if (!isSampled<CellContext>(name)) requireOnDemand(name, Scope::cell);
  return worldColumn(state_->now(), state_->cells(), name);
}

std::vector<MeasureInfo> Simulator::measures() {
  std::vector<MeasureInfo> all;
  for (const WorldMeasure& m : morula::measures<Observation>()) all.push_back({m.name, m.unit, m.meaning, false});
  for (const CellMeasure& m : morula::measures<CellContext>()) all.push_back({m.name, m.unit, m.meaning, true});
  return all;
}

}  // namespace morula
