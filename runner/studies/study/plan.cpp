#include "study/plan.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

#include "base/error.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/write_file.h"
#include "observation/asked_measure.h"
#include "parts/prediction.h"
#include "study/conditions.h"
#include "study/study_table.h"
#include "system/clock.h"

namespace morula {
namespace {

constexpr double rehearsedVertexSteps = 1e5;  // about 0.01 s; measuring the rates takes as long
// Settlings take more evaluations the more cells there are; a rehearsal of 0.2 s includes some cells.
constexpr double settledVertexSteps = 2e6;

std::size_t changedLevels(const Condition& condition) {
  return std::size_t(std::ranges::count_if(condition.levels, [](std::size_t level) { return level > 0; }));
}

/// Sorts conditions: those that differ least from the first one come first.
std::vector<std::size_t> orderOf(const std::vector<Condition>& conditions) {
  std::vector<std::size_t> order(conditions.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return changedLevels(conditions[i]); });
  return order;
}

/// Estimates the size of a result [byte] by the sizes of its rows in SQLite.
double diskOf(const Study& study, const Scenario& scenario, const Prediction& f) {
  constexpr double empty = 27e3;  // tables, and the record of the run
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

/// Predicts a cost by the beginning of a run. Absent if the run stops there: that will be its result.
std::optional<RunCost> rehearse(const Study& study, const Scenario& scenario, const PlanOptions& options,
                                double vertexSteps = rehearsedVertexSteps) {
  const PredictionOptions how{.ask = {.pictures = false}, .execution = options.execution, .trial = vertexSteps};
  try {
    const Prediction f = predictCost(scenario, how);
    return RunCost{f.seconds(), f.bytes(), diskOf(study, scenario, f), true};
  } catch (const NumericalError&) { return std::nullopt; }
}

/// Estimates a cost as if each level made runs longer by a factor of its own.
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

/// Predicts a cost for each condition. Until `options.rehearsal` is used up, runs are rehearsed: the first condition,
/// then conditions that differ from it in one axis, in two, and so on. Other costs are the first one's times a factor
/// for each level: the relative cost of the condition that differs from the first in that level alone.
std::vector<RunCost> predictCosts(const Plan& plan, const PlanOptions& options) {
  const auto& conditions = plan.conditions;
  std::vector<std::optional<RunCost>> tried(conditions.size());
  std::map<Hash, std::size_t> known;  // equal conditions cost the same
  std::map<std::pair<std::size_t, std::size_t>, RunCost>
      ofLevel;  // costs of conditions that differ from the first in this level alone
  std::optional<RunCost> first;
  const double begin = seconds(ClockKind::process);
  double longest = 0;  // [s] longest rehearsal
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

/// Predicts the costs by one rehearsal for each base; needs plan.costs.
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
      else cost.refused = "the run stops at its beginning";
    } catch (const InputError& error) {  // the first line without its place, which is not in the scenario's file
      const std::string text = error.what();
      const auto key = text.find(": ") + 2;
      cost.refused = text.substr(key, text.find('\n') - key);
    }
    all.push_back(cost);
  }
  return all;
}

constexpr std::uint64_t maxPlanBytes = std::uint64_t{1} << 30;

std::string taskId(const Study& study, const Condition& condition, std::uint64_t seed) {
  Hasher hasher;
  hasher.field("task").add(condition.meaning);
  if (condition.usesSeed) hasher.field("seed").add(seed);
  hasher.field("measures").add(std::uint64_t{study.measures.size()});
  for (const std::string& name : study.measures) hasher.add(name);
  hasher.field("when").add(nameOf(study.when.moments)).add(study.when.every);
  hasher.field("keep").add(nameOf(study.keep.hashes)).add(nameOf(study.keep.samples)).add(nameOf(study.keep.pictures));
  return hasher.digest().text().substr(0, 16);
}

}  // namespace

namespace study {

void addTasks(Plan& plan) {
  std::map<std::string, std::size_t> known;
  for (const Condition& condition : plan.conditions)
    for (const std::uint64_t seed : plan.study.seeds) {
      std::string id = taskId(plan.study, condition, seed);
      const auto [task, isNew] = known.try_emplace(id, plan.tasks.size());
      if (isNew) plan.tasks.push_back({std::move(id), condition.number, seed});
      plan.replicates.push_back({condition.number, seed, task->second});
    }
}

std::string planId(const Plan& plan) {
  Hasher hasher;
  hasher.field("plan").add(plan.study.name);
  for (const StudyAxis& axis : plan.study.axes) {
    hasher.field("axis").add(axis.name).add(std::uint64_t{axis.levels.size()});
    for (const Level& level : axis.levels) {
      hasher.field("level").add(level.label).add(std::uint64_t{level.overrides.size()});
      for (const Override& change : level.overrides) hasher.add(change.path).add(change.value).add(change.removes);
    }
  }
  hasher.field("cpu").add(plan.study.limits.cpu.value_or(0));
  hasher.field("memory").add(plan.study.limits.memory.value_or(0));
  hasher.field("conditions").add(std::uint64_t{plan.conditions.size()});
  for (const Condition& condition : plan.conditions) hasher.add(condition.meaning);
  hasher.field("replicates").add(std::uint64_t{plan.replicates.size()});
  for (const Replicate& r : plan.replicates) hasher.add(r.seed).add(plan.tasks[r.task].id);
  return hasher.digest().text();
}

}  // namespace study

Plan makePlan(const Study& study, const PlanOptions& options) {
  Plan plan;
  plan.study = study;
  scenario::Problems problems(study.file);
  plan.conditions = study::loadConditions(study, problems, plan.warnings, options.execution, study::maxConditions);
  problems.throwIfAny();
  for (Condition& condition : plan.conditions) study::finish(condition, study);
  if (options.predict) {
    plan.costs = predictCosts(plan, options);
    plan.settled = predictSettled(plan, options);
  }
  study::countFromFolder(plan);
  study::addTasks(plan);
  plan.id = study::planId(plan);
  return plan;
}

Scenario scenarioOf(const Plan& plan, const Task& task) {
  return withSeed(plan.conditions[task.condition].scenario, task.seed);
}

std::vector<std::size_t> conditionsWithoutSeeds(const Plan& plan) {
  std::vector<std::size_t> numbers;
  for (const Condition& condition : plan.conditions)
    if (!condition.usesSeed) numbers.push_back(condition.number);
  return numbers;
}

std::vector<std::vector<std::size_t>> conditionsThatShare(const Plan& plan) {
  std::vector<std::vector<std::size_t>> groups;
  std::map<Hash, std::size_t> known;
  for (const Condition& condition : plan.conditions) {
    const auto [group, isNew] = known.try_emplace(condition.meaning, groups.size());
    if (isNew) groups.emplace_back();
    groups[group->second].push_back(condition.number);
  }
  std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
  return groups;
}

std::string nameOf(const Plan& plan, std::size_t condition) {
  return study::conditionName(plan.study, plan.conditions[condition].labels);
}

std::filesystem::path studyFolder(const Study& study) {
  return std::filesystem::path("results") / "studies" / study.name;
}

std::filesystem::path planFile(const std::filesystem::path& folder) { return folder / "plan.json"; }

Plan loadPlan(const std::filesystem::path& folder) {
  const auto file = planFile(folder);
  return readPlan(readFile(file, maxPlanBytes), file.string());
}

bool keepPlan(const Plan& plan, const std::filesystem::path& folder) {
  const auto file = planFile(folder);
  if (fileExists(file)) {
    const Plan there = loadPlan(folder);
    if (there.id == plan.id) return false;
    throw InputError("'" + file.string() + "' holds another plan (" + there.id.substr(0, 8) + ", now " +
                     plan.id.substr(0, 8) +
                     "): the study or a scenario has changed since; study run --update plans the study anew and "
                     "keeps the results that it needs, --out gives the study a folder of its own");
  }
  makeFolder(folder);
  writeNewFile(file, writePlan(plan));
  return true;
}

}  // namespace morula
