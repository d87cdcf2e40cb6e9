// Descriptions of a plan for people and programs, before anything starts.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/number_text.h"
#include "files/text.h"
#include "parts/prediction.h"
#include "simulation/memory.h"
#include "statistics/sign_flip.h"
#include "study/plan.h"

namespace morula {
namespace {

constexpr std::size_t maxNamed = 10;  // max conditions in a list for people

std::string seedsText(const std::vector<std::uint64_t>& seeds) {
  const bool inARow = seeds.back() - seeds.front() + 1 == seeds.size() && std::ranges::is_sorted(seeds);
  if (inARow && seeds.size() > 2) return fmt::format("{}..{}", seeds.front(), seeds.back());
  std::vector<std::string> texts;
  for (const std::uint64_t seed : seeds) texts.push_back(std::to_string(seed));
  if (texts.size() > 20) texts.resize(20), texts.push_back("…");
  return join(texts);
}

std::string whenText(const When& when) {
  return when.moments == Moments::every          ? fmt::format("every {}", when.every)
         : when.moments == Moments::eachDivision ? "at each division"
                                                 : "at the end";
}

/// Lists conditions, each on a line, up to `maxNamed`.
std::string listOf(const Plan& plan, const std::vector<std::size_t>& conditions) {
  std::string text;
  for (std::size_t i = 0; i < std::min(conditions.size(), maxNamed); ++i)
    text += "    " + nameOf(plan, conditions[i]) + "\n";
  if (conditions.size() > maxNamed) text += fmt::format("    and {} more\n", conditions.size() - maxNamed);
  return text;
}

std::string costText(const Plan& plan) {
  const auto total = totalCost(plan);
  if (!total) return "  costs are not predicted\n";
  const auto& [least, most] = std::ranges::minmax(plan.costs, {}, &RunCost::seconds);
  const auto tried = std::size_t(std::ranges::count(plan.costs, true, &RunCost::tried));
  const std::string shortest = timeText(least.seconds), longest = timeText(most.seconds);
  std::string text = fmt::format(
      "  predicted on one thread of this machine: {} of CPU time, {} a run; at most {} of arrays; {} on disk\n",
      timeText(total->seconds), shortest == longest ? longest : shortest + " to " + longest, bytesText(total->memory),
      bytesText(total->disk));
  if (tried < plan.conditions.size())
    text += fmt::format("    the prediction rehearses {}, and scales the costs of the other conditions from these\n",
                        counted(tried, "condition"));
  const auto& limit = plan.study.limits.cpu;
  if (limit && most.seconds > *limit)
    text += fmt::format("    some runs may exceed limits.cpu-per-run, {}\n", timeText(*limit));
  for (const SettledCost& s : plan.settled)
    text += fmt::format(
        "    with physics.integrator: quasi-static, a run of {} {}\n",
        plan.study.bases[s.base].label,
        s.refused.empty() ? fmt::format("would take {} or more instead of {}", timeText(s.settled), timeText(s.seconds))
                          : "is not possible: " + s.refused);
  return text;
}

std::size_t distinctConditions(const Plan& plan) {
  std::set<Hash> meanings;
  for (const Condition& condition : plan.conditions) meanings.insert(condition.meaning);
  return meanings.size();
}

Json toJson(const RunCost& c) { return {{"cpu_seconds", c.seconds}, {"memory", c.memory}, {"disk", c.disk}}; }

/// Describes what so many seeds can show at best of counts and other values that repeat (statistics/sign_flip.h); "" if
/// nothing is compared.
std::string powerText(const Study& study) {
  std::size_t comparisons = 0;
  for (const StudyAxis& axis : study.axes) comparisons += axis.levels.size() * (axis.levels.size() - 1) / 2;
  comparisons *= study.measures.size();
  if (comparisons == 0 || study.seeds.size() < 2) return "";
  const auto corrected = [&](std::size_t seeds) {
    return std::min(1.0, smallestSignFlipP(seeds) * static_cast<double>(comparisons));
  };
  std::size_t enough = study.seeds.size();
  while (corrected(enough) >= 0.05) ++enough;
  std::string text =
      fmt::format("  {}: for values that repeat, such as counts, the min p is {}, {} after Holm over {} comparisons",
                  counted(study.seeds.size(), "seed"), numberText(smallestSignFlipP(study.seeds.size()), 2),
                  numberText(corrected(study.seeds.size()), 2), comparisons);
  if (enough > study.seeds.size())
    text += fmt::format("; to show a single such difference takes at least {} seeds", enough);
  return text + "\n";
}

}  // namespace

std::optional<RunCost> totalCost(const Plan& plan) {
  if (plan.costs.empty()) return std::nullopt;
  RunCost total;
  for (const Task& task : plan.tasks) {
    const RunCost& one = plan.costs[task.condition];
    total.seconds += one.seconds;
    total.disk += one.disk;
    total.memory = std::max(total.memory, one.memory);
  }
  return total;
}

std::string describe(const Plan& plan) {
  const Study& s = plan.study;
  std::string text = s.name + (s.summary.empty() ? "" : ": " + s.summary) + "\n";
  for (const StudyAxis& axis : s.axes) {
    std::vector<std::string> labels;
    for (const Level& level : axis.levels) labels.push_back(level.label);
    text += fmt::format("  {}: {}\n", axis.name, join(labels));
  }
  text += fmt::format("  seeds: {}\n  measures: {}, {}\n\n", seedsText(s.seeds), join(s.measures), whenText(s.when));
  text += fmt::format("  {} × {} = {}: {}, each run once\n", counted(plan.conditions.size(), "condition"),
                      counted(s.seeds.size(), "seed"), counted(plan.replicates.size(), "replicate"),
                      counted(plan.tasks.size(), "distinct scene"));
  if (const auto without = conditionsWithoutSeeds(plan); !without.empty())
    text += fmt::format(
        "  {} without random parts, which no seed changes: each is run once and compared without an interval "
        "(`variation` would make seeds differ)\n"
        "{}",
        counted(without.size(), "condition"), listOf(plan, without));
  for (const auto& group : conditionsThatShare(plan))
    text += fmt::format("  {} with the same meaning, which share their runs:\n{}", counted(group.size(), "condition"),
                        listOf(plan, group));
  return text + powerText(s) + costText(plan) + "  plan " + plan.id + "\n";
}

Json summaryOf(const Plan& plan) {
  Json conditions = Json::array(), axes = Json::array(), tasks = Json::array();
  for (const StudyAxis& axis : plan.study.axes) {
    Json labels = Json::array();
    for (const Level& level : axis.levels) labels.push_back(level.label);
    axes.push_back({{"name", axis.name}, {"labels", std::move(labels)}});
  }
  for (const Condition& c : plan.conditions) {
    Json labels = Json::object();
    for (std::size_t i = 0; i < c.labels.size(); ++i) labels[plan.study.axes[i].name] = c.labels[i];
    conditions.push_back({{"condition_id", c.number},
                          {"labels", std::move(labels)},
                          {"uses_seed", c.usesSeed},
                          {"meaning", c.meaning.text()},
                          {"cost", plan.costs.empty() ? Json() : toJson(plan.costs[c.number])}});
  }
  for (const Task& t : plan.tasks)
    tasks.push_back({{"task_id", t.id}, {"condition_id", t.condition}, {"seed", t.seed}});
  Json settled = Json::array();
  for (const SettledCost& s : plan.settled)
    settled.push_back({{"base", plan.study.bases[s.base].label},
                       {"cpu_seconds", s.seconds},
                       {"settled_cpu_seconds", s.refused.empty() ? Json(s.settled) : Json()},
                       {"refused", s.refused}});
  const auto total = totalCost(plan);
  return {{"study", plan.study.name},
          {"plan", plan.id},
          {"axes", std::move(axes)},
          {"seeds", plan.study.seeds},
          {"measures", plan.study.measures},
          {"replicates", plan.replicates.size()},
          {"distinct_conditions", distinctConditions(plan)},
          {"distinct_runs", plan.tasks.size()},
          {"without_seeds", conditionsWithoutSeeds(plan)},
          {"shared", conditionsThatShare(plan)},
          {"cost", total ? toJson(*total) : Json()},
          {"settled", std::move(settled)},
          {"conditions", std::move(conditions)},
          {"tasks", std::move(tasks)}};
}

}  // namespace morula
