
#include "state/experiment_record.h"

#include <algorithm>

#include "base/random.h"
#include "state/world.h"

namespace morula {

bool wasDone(const World& world, std::uint64_t number) {
  return std::ranges::find(*world.experiments, number, &ExperimentRecord::number) != world.experiments->end();
}

bool wasDoneTo(const World& world, std::uint64_t number, const CellPath& path) {
  return std::ranges::any_of(*world.experiments, [&](const ExperimentRecord& record) {
    return record.number == number && record.to == DoneTo::cell && record.path == path;
  });
}

bool selects(const Experiment& e, const World& world, const CellPath& path, StateId state) {
  if (e.of.empty()) return true;
  const std::string substances = world.biology->describe(state);
  return std::ranges::any_of(e.of, [&](const CellSelection& s) { return s.has(path, substances); });
}

bool isChosen(const Experiment& e, const World& world, std::uint64_t number, const CellPath& path) {
  if (e.share >= 1) return true;
  return randomUnit({world.model.seed, path, static_cast<std::uint32_t>(number), Purpose::experiment}, 0) < e.share;
}

}  // namespace morula
