#include "study/condition_mistakes.h"

#include <algorithm>

#include "files/text.h"

namespace morula::study {
namespace {

/// Whether the line names the place of a value that the level sets.
bool standsIn(const Level& level, const std::string& line) {
  return std::ranges::any_of(level.overrides,
                             [&](const Override& change) { return line.starts_with(change.place + ":"); });
}

/// " (under connections: none)", " (in 3 of 15 conditions, the first division: longest, connections: both)"; "" if all have
/// it, and if it names the place of the one level whose conditions have it.
std::string whereText(const Study& study, const std::vector<Condition>& conditions, const std::string& line,
                      const std::set<std::size_t>& has) {
  if (has.size() == conditions.size()) return "";
  for (std::size_t axis = 0; axis < study.axes.size(); ++axis)
    for (std::size_t level = 0; level < study.axes[axis].levels.size(); ++level) {
      const Level& one = study.axes[axis].levels[level];
      const auto isOfLevel = [&](const Condition& c) { return c.levels[axis] == level; };
      if (std::ranges::all_of(conditions, [&](const Condition& c) { return isOfLevel(c) == has.contains(c.number); }))
        return standsIn(one, line) ? "" : " (under " + study.axes[axis].name + ": " + one.label + ")";
    }
  const auto first = std::ranges::find(conditions, *has.begin(), &Condition::number);
  const std::string name = conditionName(study, first->labels);
  if (has.size() == 1) return " (under " + name + ")";
  return " (in " + std::to_string(has.size()) + " of " + std::to_string(conditions.size()) + " conditions, the first " +
         name + ")";
}

}  // namespace

void ConditionMistakes::add(std::size_t condition, const std::string& lines) {
  for (const std::string& line : linesOf(lines)) {
    if (line.empty()) continue;
    const auto [at, isNew] = numbers_.try_emplace(line, lines_.size());
    if (isNew) lines_.push_back({line, {}});
    lines_[at->second].conditions.insert(condition);
  }
}

void ConditionMistakes::tell(const Study& study, const std::vector<Condition>& conditions,
                             scenario::Problems& problems) const {
  for (const auto& [line, has] : lines_) problems.addForeign({}, line + whereText(study, conditions, line, has));
}

std::string conditionName(const Study& study, const std::vector<std::string>& labels) {
  std::string text;
  for (std::size_t axis = 0; axis < labels.size(); ++axis)
    text += (text.empty() ? "" : ", ") + study.axes[axis].name + ": " + labels[axis];
  return text.empty() ? "the scenario as it is" : text;
}

}  // namespace morula::study
