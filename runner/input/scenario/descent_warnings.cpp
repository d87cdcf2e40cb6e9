// Warnings of scenarios in which a line of descent outgrows the paths of cells.
#include <map>
#include <queue>

#include "base/number_text.h"
#include "biology/logical_dna.h"
#include "scenario/scene_checks.h"
#include "simulation/cycle_lengths.h"

namespace morula::scenario {
namespace {

constexpr std::size_t maxStates = 4096;  // a DNA with more states is not followed

using Births = std::map<StateId, double>;  // earliest birth of a cell with this state [time]

/// Returns the daughters of cells that are born so early, or nothing if too many states are met on the way.
std::optional<Births> daughtersOf(const Births& mothers, BiologicalUnit& biology, double end) {
  using Cell = std::pair<double, StateId>;  // last cycle or birth [time], state
  std::priority_queue<Cell, std::vector<Cell>, std::greater<>> waiting;
  for (const auto& [state, born] : mothers) waiting.emplace(born, state);
  Births seen = mothers, daughters;
  while (!waiting.empty()) {
    CellContext cell;
    std::tie(cell.lastCycle, cell.state) = waiting.top();
    waiting.pop();
    if (cell.lastCycle > seen[cell.state]) continue;  // a later way to a state that was left already
    const double due = cell.lastCycle + biology.cycleLength(cell.state);
    if (due > end) continue;
    cell.state = biology.runCellCycle(cell);
    cell.time = cell.lastCycle = due;
    if (biology.wantsToDie(cell)) continue;
    const bool divides = biology.wantsToDivide(cell);
    Births& births = divides ? daughters : seen;
    for (const bool b : {false, true}) {
      const StateId next = divides ? biology.daughterState(cell.state, b) : cell.state;
      const auto [entry, isNew] = births.emplace(next, due);
      if (!isNew && entry->second <= due) continue;
      entry->second = due;
      if (!divides) waiting.emplace(due, next);
    }
    if (seen.size() + daughters.size() > maxStates) return {};
  }
  return daughters;
}

}  // namespace

std::vector<std::string> descentWarnings(const Scenario& scenario, const Node& root) {
  const Scene& scene = scenario.scene;
  const auto end = plannedEnd(scene);
  if (!end || *end < CellPath::maxDepth * shortestCycle(scene).length) return {};
  // The run alone tells what cells sense, their sizes, their number and the experiments.
  if (!scene.senses.empty() || scene.cycle.divisionSize || scene.variation.cycle > 0 || scene.stop.cells || !scene.stop.when.empty() ||
      !scene.experiments.empty())
    return {};
  const auto biology = makeLogicalDna(scene.dna, scene.cycle);
  Births cells{{biology->startState(), 0}};
  for (int divisions = 0; divisions <= CellPath::maxDepth; ++divisions) {
    auto daughters = daughtersOf(cells, *biology, *end);
    if (!daughters || daughters->empty()) return {};
    cells = std::move(*daughters);
  }
  double first = INFINITY;  // [time] of the first division that cannot be recorded
  for (const auto& [state, born] : cells) first = std::min(first, born);
  return {placeText(scenario.file, placeOf(root, "stop")) + ": stop: a cell divides for the " +
          std::to_string(CellPath::maxDepth + 1) + "st time on its line of descent at time " + exactText(first) +
          ", and a cell's path holds " + std::to_string(CellPath::maxDepth) +
          " divisions: the run will fail at that time; stop earlier, or let the genes stop the division"};
}

}  // namespace morula::scenario
