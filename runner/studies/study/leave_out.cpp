// Combinations of levels that a study leaves out, and what axes and labels are called.
#include <algorithm>

#include "base/did_you_mean.h"
#include "files/text.h"
#include "study/study_table.h"
#include "values/value_types.h"

namespace morula::study {

using scenario::Member;
using scenario::Node;
using scenario::Problems;

namespace {

const std::string leaveOutAllowed = "a list of combinations, as [{division: random, drag: [8, 16]}]";

void readCombination(const Node& node, const std::string& path, Study& study, Problems& problems) {
  if (node.kind != Node::Kind::map || node.members.empty())
    return problems.add(node.place, path, "is no combination",
                        "needs a map of axes and labels, as {division: random, drag: [8, 16]}");
  const std::size_t before = problems.size();
  LeftOut combination{std::vector<std::vector<std::size_t>>(study.axes.size()), node.place};
  for (const Member& member : node.members) {
    const auto axis = axisNamed(study, member, path, problems);
    if (!axis) continue;
    const std::string at = path + "." + member.key;
    const bool isList = member.value.kind == Node::Kind::sequence && !member.value.items.empty();
    for (const Node& label : isList ? member.value.items : std::vector{member.value})
      if (const auto level = levelNamed(study.axes[*axis], label, at, problems))
        combination.levels[*axis].push_back(*level);
  }
  if (problems.size() == before) study.leftOut.push_back(std::move(combination));
}

}  // namespace

std::string nearOf(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = closest(word, known);
  return near.empty() ? "it has " + join(known) : "did you mean " + near + "?";
}

std::optional<std::size_t> axisNamed(const Study& study, const Member& member, const std::string& path,
                                     Problems& problems) {
  std::vector<std::string> axes;
  for (const StudyAxis& axis : study.axes) axes.push_back(axis.name);
  const auto found = std::ranges::find(axes, member.key);
  if (found != axes.end()) return found - axes.begin();
  problems.add(member.place, path + "." + member.key, "the study has no axis of this name", nearOf(member.key, axes));
  return std::nullopt;
}

std::optional<std::size_t> levelNamed(const StudyAxis& axis, const Node& label, const std::string& path,
                                      Problems& problems) {
  std::vector<std::string> labels;
  for (const Level& level : axis.levels) labels.push_back(level.label);
  const auto text = scenario::readText(label, path, "a label", problems);
  if (!text) return std::nullopt;
  const auto found = std::ranges::find(labels, *text);
  if (found != labels.end()) return found - labels.begin();
  problems.add(label.place, path, "there is no label '" + *text + "'", nearOf(*text, labels));
  return std::nullopt;
}

Key leaveOutKey() {
  const Json text{{"type", Json::array({"string", "number"})}};
  const Json labels{{"oneOf", Json::array({text, {{"type", "array"}, {"items", text}, {"minItems", 1}}})}};
  return {"leave-out",
          leaveOutAllowed,
          "Combinations of levels that are not run: those with one of the named labels in each of the named axes. "
          "Effects of axes and interactions need all combinations; a study without some compares pairs alone",
          "all combinations are run",
          {{"type", "array"},
           {"items", {{"type", "object"}, {"additionalProperties", labels}, {"minProperties", 1}}},
           {"minItems", 1}},
          [](Study&, const Node&, Problems&) {}};  // read by readLeftOut, once all axes are known
}

void readLeftOut(const Node& root, Study& study, Problems& problems) {
  const auto* member = root.find("leave-out");
  if (!member || !scenario::expectEntries(member->value, "leave-out", leaveOutAllowed, problems)) return;
  for (std::size_t i = 0; i < member->value.items.size(); ++i)
    readCombination(member->value.items[i], "leave-out[" + std::to_string(i) + "]", study, problems);
}

}  // namespace morula::study
