#include "study/costs.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "base/error.h"
#include "parts/prediction.h"
#include "simulation/asked_measure.h"
#include "system/clock.h"

namespace morula::study {
namespace {

constexpr double rehearsedVertexSteps = 1e5;  // a hundredth of a second, and what its rates take as long
// Settlings take more evaluations the more cells there are: a fifth of a second shows some of them.
constexpr double settledVertexSteps = 2e6;

std::size_t changedLevels(const Condition& condition) {
  return std::size_t(std::ranges::count_if(condition.levels, [](std::size_t level) { return level > 0; }));
}

/// Those that differ least from the first condition come first.
std::vector<std::size_t> orderOf(const std::vector<Condition>& conditions) {
  std::vector<std::size_t> order(conditions.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return changedLevels(conditions[i]); });
  return order;
}

/// [byte] Of a result, by the sizes of its rows in SQLite.
double diskOf(const Study& study, const Scenario& scenario, const Prediction& f) {
  constexpr double empty = 27e3;  // tables, and the record of how it was run
  constexpr double perValue = 40, perCell = 100, perSampledCell = 600, perHash = 40, perPicture = 190e3;
  const double divisions = double(f.life.divisions), cells = double(f.cells), end = f.life.eras.back().to;
  const double moments = study.when.moments == Moments::every          ? 2 + end / study.when.every
                         : study.when.moments == Moments::eachDivision ? 2 + divisions
                                                                       : 1;
  const double sampled = study.keep.samples == SamplesKept::all ? moments : 1;
  double bytes = empty + double(scenario.bytes.size() + scenario.resolved.size()) +
                 perValue * moments * double(study.measures.size()) + perCell * (2 * divisions + 1);
  if (scenario.scene.mechanics) bytes += perSampledCell * cells * sampled;
  if (study.keep.hashes == HashesKept::all) bytes += perHash * f.steps / (scenario.scene.mechanics ? 64 : 1);
  if (study.keep.pictures == PicturesKept::all) bytes += perPicture;
  if (study.keep.pictures == PicturesKept::firstSeed) bytes += perPicture / double(study.seeds.size());
  return bytes;
}

/// None if the run stops at its beginning: that will be its result.
std::optional<RunCost> rehearse(const Study& study, const Scenario& scenario, const PlanOptions& options,
                                double vertexSteps = rehearsedVertexSteps) {
  PredictionOptions how;
  how.execution = options.execution;
  how.ask.pictures = false;
  how.trial = vertexSteps;
  try {
    const Prediction f = predictCost(scenario, how);
    return RunCost{f.seconds(), f.bytes(), diskOf(study, scenario, f), true};
  } catch (const NumericalError&) { return std::nullopt; }
}

/// As if each level made runs longer by a factor of its own.
RunCost estimate(const Condition& condition, const RunCost& first,
                 const std::map<std::pair<std::size_t, std::size_t>, RunCost>& ofLevel) {
  RunCost cost = first;
  cost.tried = false;
  for (std::size_t axis = 0; axis < condition.levels.size(); ++axis) {
    const auto one = ofLevel.find({axis, condition.levels[axis]});
    if (one == ofLevel.end()) continue;
    for (double RunCost::*part : {&RunCost::seconds, &RunCost::memory, &RunCost::disk})
      if (first.*part > 0) cost.*part *= one->second.*part / first.*part;
  }
  return cost;
}

}  // namespace

std::vector<RunCost> predictCosts(const Plan& plan, const PlanOptions& options) {
  const auto& conditions = plan.conditions;
  std::vector<std::optional<RunCost>> tried(conditions.size());
  std::map<Hash, std::size_t> known;  // equal conditions cost the same
  std::map<std::pair<std::size_t, std::size_t>, RunCost>
      ofLevel;  // of conditions that differ from the first in it alone
  std::optional<RunCost> first;
  const double begin = seconds(ClockKind::process);
  double longest = 0;  // [s] that a rehearsal took
  for (const std::size_t i : orderOf(conditions)) {
    const Condition& condition = conditions[i];
    const auto [same, isNew] = known.try_emplace(condition.meaning, i);
    if (!isNew) tried[i] = tried[same->second];
    else if (const double before = seconds(ClockKind::process);
             !first || before - begin + longest < options.rehearsal) {
      tried[i] = rehearse(plan.study, condition.scenario, options);
      longest = std::max(longest, seconds(ClockKind::process) - before);
    }
    if (!tried[i]) continue;
    if (!first) first = tried[i];
    if (changedLevels(condition) != 1) continue;
    const auto changed = std::ranges::find_if(condition.levels, [](std::size_t level) { return level > 0; });
    ofLevel[{std::size_t(changed - condition.levels.begin()), *changed}] = *tried[i];
  }
  std::vector<RunCost> costs;
  for (const Condition& condition : conditions)
    costs.push_back(tried[condition.number] ? *tried[condition.number]
                    : first                 ? estimate(condition, *first, ofLevel)
                                            : RunCost{});
  return costs;
}

std::vector<SettledCost> predictSettled(const Plan& plan, const PlanOptions& options) {
  std::vector<SettledCost> all;
  for (std::size_t base = 0; base < plan.study.bases.size(); ++base) {
    const auto condition = std::ranges::find(plan.conditions, base, &Condition::base);
    if (condition == plan.conditions.end()) continue;
    SettledCost cost{base, plan.costs[condition->number].seconds, 0, ""};
    try {
      const auto settled = settledInstead(condition->scenario);
      if (!settled) continue;
      if (const auto run = rehearse(plan.study, *settled, options, settledVertexSteps)) cost.settled = run->seconds;
      else cost.refused = "it stops at its beginning";
    } catch (const InputError& error) {  // its first line without the place, which is none of the scenario's file
      const std::string text = error.what();
      const auto key = text.find(": ") + 2;
      cost.refused = text.substr(key, text.find('\n') - key);
    }
    all.push_back(cost);
  }
  return all;
}

}  // namespace morula::study
