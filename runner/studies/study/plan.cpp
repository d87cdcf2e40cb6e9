#include "study/plan.h"

#include <algorithm>
#include <map>

#include "study/condition_mistakes.h"
#include "study/conditions.h"
#include "study/costs.h"
#include "study/plan_parts.h"
#include "study/study_table.h"

namespace morula {

namespace study {

namespace {

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

void addLimits(Hasher& hasher, const RunLimits& limits) {
  hasher.field("cpu").add(limits.cpu.value_or(0));
  hasher.field("memory").add(limits.memory.value_or(0));
}

}  // namespace

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
  addLimits(hasher, plan.study.limits);
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
  plan.conditions = study::loadConditions(study, problems, plan.warnings, options.execution, study::mostConditions);
  problems.throwIfAny();
  for (Condition& condition : plan.conditions) study::finish(condition, study);
  if (options.predict) {
    plan.costs = study::predictCosts(plan, options);
    plan.settled = study::predictSettled(plan, options);
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

}  // namespace morula
