#include "library/morula.h"

#include <algorithm>

#include "base/error.h"
#include "base/floating_point.h"
#include "library/scene_format.h"
#include "observation/measures.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"

namespace morula {

struct Simulator::State {
  World world;
};

namespace {

template <class Of>
bool isSampled(std::string_view name) {
  const auto rows = sampledMeasures<Of>();
  return std::any_of(rows.begin(), rows.end(), [&](const Measure<Of>& row) { return row.name == name; });
}

/// Takes a measure on demand of the world, or of the cell with this path.
std::optional<double> takeOnDemand(const Observation& now, std::string_view name, Scope scope, const CellPath& path) {
  const auto all = measuresOnDemand();
  if (std::none_of(all.begin(), all.end(),
                   [&](const MeasureOnDemand& m) { return m.name == name && m.scope == scope; }))
    throw InputError("there is no measure '" + std::string(name) + "' of " +
                     (scope == Scope::world ? "the organism" : "cells") + "; morula schema --measures lists them");
  for (const TakenMeasure& taken : takeMeasures(now, std::vector{std::string(name)}))
    if (taken.a == path) return taken.value;
  return {};
}

World makeFrom(std::string_view scene, int threads) {
  setFloatingPoint();
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

Simulator::Simulator(std::string_view scene, int threads) : state_(new State{makeFrom(scene, threads)}) {}
Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

void Simulator::step(std::uint64_t most) {
  setFloatingPoint();
  World& world = state_->world;
  const std::uint64_t end = world.clock.step + most;
  while (world.clock.step < end && !morula::finished(world)) takeSteps(world, end - world.clock.step);
}

bool Simulator::finished() const { return morula::finished(state_->world); }
std::uint64_t Simulator::steps() const { return state_->world.clock.step; }
double Simulator::now() const { return state_->world.clock.time; }
std::optional<double> Simulator::end() const { return plannedEnd(state_->world.model); }
std::string Simulator::hash() const { return stateHash(state_->world).text(); }
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

std::optional<double> Simulator::measure(std::string_view name) const {
  const Observation now(state_->world);
  if (isSampled<Observation>(name)) return measureWorld(now)[name];
  return takeOnDemand(now, name, Scope::world, {});
}

std::optional<double> Simulator::measure(std::string_view name, std::size_t cell) const {
  const CellPath& path = pathOf(state_->world, cell);
  const Observation now(state_->world);
  if (!isSampled<CellContext>(name)) return takeOnDemand(now, name, Scope::cell, path);
  const auto cells = measureCells(now);
  return cells.empty() ? std::nullopt : cells[cell][name];
}

}  // namespace morula
