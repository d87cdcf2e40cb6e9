#include "study/condition_mistakes.h"

#include <algorithm>

#include "files/text.h"

namespace morula::study {

namespace {

/// "under connections: none", "in 3 of 15 conditions, the first division: longest, connections: both"; "" if all have it.
std::string whereText(const Study& study, const std::vector<Condition>& conditions,
                      const std::set<std::size_t>& has) {
  if (has.size() == conditions.size()) return "";
  for (std::size_t axis = 0; axis < study.axes.size(); ++axis)
    for (std::size_t level = 0; level < study.axes[axis].levels.size(); ++level) {
      const auto isOfLevel = [&](const Condition& c) { return c.levels[axis] == level; };
      if (std::ranges::all_of(conditions,
                              [&](const Condition& c) { return isOfLevel(c) == has.contains(c.number); }))
        return "under " + study.axes[axis].name + ": " + study.axes[axis].levels[level].label;
    }
  const auto first = std::ranges::find(conditions, *has.begin(), &Condition::number);
  return "in " + std::to_string(has.size()) + " of " + std::to_string(conditions.size()) +
         " conditions, the first " + conditionName(study, first->labels);
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
  for (const auto& [line, has] : lines_) {
    const std::string where = whereText(study, conditions, has);
    // Who reads the place of a level's value needs not to be told the level.
    const bool saysIt = line.starts_with(study.file + ":") && where.starts_with("under ");
    problems.addForeign({}, where.empty() || saysIt ? line : line + " (" + where + ")");
  }
}

std::string conditionName(const Study& study, const std::vector<std::string>& labels) {
  std::string text;
  for (std::size_t axis = 0; axis < labels.size(); ++axis)
    text += (text.empty() ? "" : ", ") + study.axes[axis].name + ": " + labels[axis];
  return text.empty() ? "the scenario as it is" : text;
}

}  // namespace morula::study
