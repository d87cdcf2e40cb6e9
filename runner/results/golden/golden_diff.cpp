#include "golden/golden_diff.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "golden/number_text.h"

namespace morula {

namespace {

/// The last rule that matches; null if none does.
const ToleranceRule* ruleFor(const std::vector<ToleranceRule>& rules, const GoldenItem& value) {
  const ToleranceRule* holds = nullptr;
  for (const ToleranceRule& rule : rules)
    if (rule.matches(value.key, stepOf(value).value_or(0))) holds = &rule;
  return holds;
}

std::map<std::string, const GoldenItem*> byName(const GoldenData& data) {
  std::map<std::string, const GoldenItem*> items;
  for (const GoldenItem& item : data.items) items.emplace(item.kind + ' ' + item.key, &item);
  return items;
}

/// "3 lines removed:" and the first nine of them.
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
  const auto before = byName(old.data);
  for (GoldenItem& item : observed.items) {
    if (item.kind != "value") continue;
    const auto found = before.find(item.kind + ' ' + item.key);
    if (found == before.end() || found->second->fields[0] != item.fields[0]) continue;
    const ToleranceRule* rule = ruleFor(old.rules, item);
    const auto e = readReal(found->second->fields[1]), a = readReal(item.fields[1]);
    if (rule && e && a && rule->tolerance.passes(*e, *a)) item.fields = found->second->fields;
  }
  return observed;
}

std::vector<ToleranceRule> limitToHorizon(const Golden& golden, std::vector<std::string>& notes) {
  std::vector<ToleranceRule> limited;
  for (ToleranceRule rule : golden.rules) {
    const auto horizon = horizonOf(golden, rule.tolerance.size());
    const auto matchesOne = [&] {
      return std::any_of(golden.data.items.begin(), golden.data.items.end(), [&](const GoldenItem& item) {
        return item.kind == "value" && rule.matches(item.key, stepOf(item).value_or(0));
      });
    };
    const bool isLoose = rule.tolerance.kind != Tolerance::Kind::exact;
    if (isLoose && horizon && (!rule.untilStep || *rule.untilStep >= *horizon)) {
      const std::string before = rule.text();
      rule.untilStep = *horizon - std::min<std::uint64_t>(*horizon, 1);
      if (!matchesOne()) {
        notes.push_back("dropped, as it says something only beyond the chaos horizon: " + before);
        continue;
      }
      notes.push_back("ends at the chaos horizon now, step " + std::to_string(*rule.untilStep) + ": " +
                      before);
    }
    limited.push_back(std::move(rule));
  }
  return limited;
}

std::vector<std::string> loosenedTolerances(const Golden& before, const Golden& golden) {
  std::map<std::string, std::size_t> count;  // by the rule that is looser
  for (const GoldenItem& item : golden.data.items) {
    if (item.kind != "value") continue;
    const double expected = readReal(item.fields[1]).value_or(0);
    const ToleranceRule *was = ruleFor(before.rules, item), *is = ruleFor(golden.rules, item);
    const auto allowed = [&](const ToleranceRule* rule) {
      return rule ? rule->tolerance.allowed(expected) : 0;
    };
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
  std::vector<std::string> removed, added, lineage, bits, values, others;
  for (const GoldenItem& item : golden.data.items) {
    const auto now = after.find(item.kind + ' ' + item.key);
    if (now == after.end()) {
      removed.push_back(write(item));
      continue;
    }
    if (item.fields == now->second->fields) continue;
    const bool life = item.kind == "cell" || item.kind == "generation";
    const bool isBits = item.kind == "bits" || item.kind == "step_hash";
    (life                   ? lineage
     : isBits               ? bits
     : item.kind == "value" ? values
                            : others)
        .push_back(write(item) + "  →  " + write(*now->second));
  }
  for (const GoldenItem& item : observed.items)
    if (!before.contains(item.kind + ' ' + item.key)) added.push_back(write(item));
  return section("removed", removed) + section("new", added) + section("changed in the lineage", lineage) +
         section("changed bits", bits) + section("changed values", values) +
         section("changed of pictures, counts and costs", others);
}

}  // namespace morula
