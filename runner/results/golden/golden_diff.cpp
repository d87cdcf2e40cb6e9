#include "golden/golden_diff.h"

#include <algorithm>
#include <map>

#include "golden/read_number.h"
#include "golden/toleranced_numbers.h"

namespace morula {
namespace {

std::map<std::string, const GoldenItem*> byName(const GoldenData& data) {
  std::map<std::string, const GoldenItem*> items;
  for (const GoldenItem& item : data.items) items.emplace(idOf(item), &item);
  return items;
}

/// Returns "3 lines removed:" and the first nine of the lines.
std::string section(const std::string& heading, const std::vector<std::string>& lines) {
  constexpr std::size_t most = 9;
  if (lines.empty()) return {};
  std::string text = std::to_string(lines.size()) + ' ' + heading + '\n';
  for (std::size_t i = 0; i < std::min(most, lines.size()); ++i) text += "  " + lines[i] + '\n';
  if (lines.size() > most) text += "  and " + std::to_string(lines.size() - most) + " more\n";
  return text;
}

}  // namespace

GoldenData keepValuesWithinTolerance(GoldenData observed, const Golden& old) {
  std::map<ValueName, const GoldenValue*> before;
  for (const auto* value : all<GoldenValue>(old.data)) before.emplace(value->name, value);
  for (GoldenItem& item : observed.items) {
    auto* value = std::get_if<GoldenValue>(&item);
    const auto found = value ? before.find(value->name) : before.end();
    if (found == before.end() || found->second->step != value->step) continue;
    const std::optional<double> was = found->second->value;
    if (!was || !value->value) continue;
    const ToleranceRule* rule = ruleFor(old.rules, {goldenText(value->name), value->step, *value->value});
    if (rule && rule->tolerance.passes(*was, *value->value)) value->value = was;
  }
  return observed;
}

std::vector<ToleranceRule> limitToHorizon(const Golden& golden, std::vector<std::string>& notes) {
  std::vector<ToleranceRule> limited;
  const std::vector<GoldenNumber> numbers = numbersIn(golden.data);
  for (ToleranceRule rule : golden.rules) {
    const auto horizon = horizonOf(golden, rule.tolerance.size());
    const auto matchesOne = [&] {
      return std::ranges::any_of(numbers, [&](const GoldenNumber& n) { return rule.matches(n.name, n.step); });
    };
    const bool isLoose = rule.tolerance.kind != Tolerance::Kind::exact;
    if (isLoose && horizon && (!rule.untilStep || *rule.untilStep >= *horizon)) {
      const std::string before = rule.text();
      rule.untilStep = *horizon - std::min<std::uint64_t>(*horizon, 1);
      if (!matchesOne()) {
        notes.push_back("dropped, because it applies only beyond the chaos horizon: " + before);
        continue;
      }
      notes.push_back("now ends at the chaos horizon, step " + std::to_string(*rule.untilStep) + ": " + before);
    }
    limited.push_back(std::move(rule));
  }
  return limited;
}

std::vector<std::string> loosenedTolerances(const Golden& before, const Golden& golden) {
  std::map<std::string, std::size_t> count;  // values by the looser rule
  for (const GoldenNumber& number : numbersIn(golden.data)) {
    const ToleranceRule *was = ruleFor(before.rules, number), *is = ruleFor(golden.rules, number);
    const auto allowed = [&](const ToleranceRule* rule) { return rule ? rule->tolerance.allowed(number.value) : 0; };
    if (allowed(is) > allowed(was))
      ++count["`" + is->text() + "`, before " + (was ? "`" + was->text() + "`" : "exact")];
  }
  std::vector<std::string> lines;
  for (const auto& [rule, values] : count)
    lines.push_back(std::to_string(values) + (values == 1 ? " value: " : " values: ") + rule);
  return lines;
}

std::string describeGoldenDiff(const Golden& golden, const GoldenData& observed) {
  const auto before = byName(golden.data), after = byName(observed);
  std::vector<std::string> removed, added, lineage, bits, values, tables, others;
  for (const GoldenItem& item : golden.data.items) {
    const auto now = after.find(idOf(item));
    if (now == after.end()) {
      removed.push_back(write(item));
      continue;
    }
    if (agree(item, *now->second)) continue;
    const std::string check = checkOf(item);
    (check == "lineage"                          ? lineage
     : check == "bits" || check == "step_hashes" ? bits
     : check == "values"                         ? values
     : check == "tables"                         ? tables
                                                 : others)
        .push_back(write(item) + "  →  " + write(*now->second));
  }
  for (const GoldenItem& item : observed.items)
    if (!before.contains(idOf(item))) added.push_back(write(item));
  return section("removed", removed) + section("new", added) + section("changed in the lineage", lineage) +
         section("changed bits", bits) + section("changed values", values) +
         section("changed in recorded tables", tables) + section("changed in pictures, counts and costs", others);
}

}  // namespace morula
