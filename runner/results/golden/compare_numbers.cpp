#include "golden/compare_numbers.h"

#include <algorithm>
#include <cmath>

#include "files/text.h"
#include "golden/read_number.h"
#include "golden/toleranced_numbers.h"

namespace morula {
namespace {

/// A number of the golden with the run's.
struct NumberPair {
  const GoldenNumber& golden;
  double actual;
  std::string place;                // "file:line"
  std::optional<std::string> cell;  // its path, if the number belongs to one cell
  std::string field;
};

/// The numbers to which one rule applies (null: no rule, so they must be exact).
struct RuleCheck {
  const ToleranceRule* rule = nullptr;
  std::vector<Difference> differences;
  std::size_t values = 0;
  double share = 0;                 // the largest used share; `cell` and `field` tell where
  std::optional<std::string> cell;  // its path
  std::string field;
  bool chaos = true;  // true if every difference may have grown from one unit in the last place

  void add(const Golden& golden, const NumberPair& pair) {
    const std::string& file = golden.file;
    const Tolerance tolerance = rule ? rule->tolerance : Tolerance{};
    const double e = pair.golden.value, a = pair.actual;
    const double used = tolerance.share(e, a);
    if (++values == 1 || used > share) share = used, cell = pair.cell, field = pair.field;
    if (used <= 1) return;
    const double grown = grownBy(golden, pair.golden.step) * std::max(std::abs(e), 1.0);
    chaos = chaos && grown > 0 && std::abs(a - e) <= grown;
    Difference d{pair.place, pair.golden.step, pair.cell, pair.field, exactText(e), exactText(a), ""};
    d.text = d.place + ": " + pair.golden.name + " at step " + std::to_string(pair.golden.step) + ": " +
             compareInWords(e, a) + "; tolerance " + tolerance.text();
    if (tolerance.kind != Tolerance::Kind::exact) d.text += ", used " + exactText(used) + " times";
    if (rule) d.text += " (" + file + ':' + std::to_string(rule->line) + ')';
    differences.push_back(std::move(d));
  }

  CheckResult result() && {
    CheckResult r = resultOf(rule ? "values " + rule->pattern : "values", std::move(differences), values);
    if (!r.passed && chaos) r.failureClass = FailureClass::chaos;
    if (!rule) return r;
    r.tolerance = rule->tolerance.text();
    if (rule->untilStep) r.tolerance += " until_step " + std::to_string(*rule->untilStep);
    if (rule->tolerance.kind == Tolerance::Kind::exact) return r;
    r.share = share;
    if (r.passed) r.cell = cell, r.field = field;
    return r;
  }
};

/// Returns a mistake in a rule itself, with the rule's line.
Difference ofRule(const Golden& golden, const ToleranceRule& rule, std::optional<std::uint64_t> step,
                  const std::string& what) {
  const std::string place = golden.file + ':' + std::to_string(rule.line);
  return {place, step, {}, "tolerance", rule.pattern, "", place + ": " + what};
}

/// Notes a rule that applies beyond the chaos horizon: there a difference in the last place alone exceeds its
/// tolerance, so the rule tests nothing.
void noteHorizon(const Golden& golden, const ToleranceRule& rule, std::uint64_t step,
                 std::map<int, Difference>& blind) {
  const auto horizon = horizonOf(golden, rule.tolerance.size());
  if (rule.tolerance.kind == Tolerance::Kind::exact || !horizon || step < *horizon) return;
  const std::string what = "the rule '" + rule.pattern + "' allows " + rule.tolerance.text() + " at step " +
                           std::to_string(step) + ", but from step " + std::to_string(*horizon) +
                           " on, the chaos horizon, an error of one unit in the last place has grown as large; add "
                           "until_step " +
                           std::to_string(*horizon - std::min<std::uint64_t>(*horizon, 1)) + " before why";
  blind.try_emplace(rule.line, ofRule(golden, rule, step, what));
}

std::string placeIn(const Golden& golden, int line) { return golden.file + ':' + std::to_string(line); }

/// Compares numbers one after the other, each by the rule that applies to it.
class NumberComparison {
 public:
  explicit NumberComparison(const Golden& golden)
      : golden_(golden), checks_(golden.rules.size() + 1), matched_(golden.rules.size(), false) {
    for (std::size_t i = 0; i < golden.rules.size(); ++i) checks_[i].rule = &golden.rules[i];
  }

  /// Compares a number. `actual`: the run's number; if absent, only the rule is examined.
  void add(const GoldenNumber& number, std::optional<double> actual, int line, const std::optional<std::string>& cell,
           const std::string& field) {
    const auto& rules = golden_.rules;
    std::size_t holds = rules.size();
    for (std::size_t i = 0; i < rules.size(); ++i)
      if (rules[i].matches(number.name, number.step)) matched_[i] = true, holds = i;  // the last wins
    if (actual) checks_[holds].add(golden_, {number, *actual, placeIn(golden_, line), cell, field});
    if (holds < rules.size()) noteHorizon(golden_, rules[holds], number.step, blind_);
  }

  /// Adds the mistakes in the rules themselves.
  void addTolerances(std::vector<CheckResult>& results) {
    const auto& rules = golden_.rules;
    if (rules.empty()) return;
    std::vector<Difference> idle;
    for (std::size_t i = 0; i < rules.size(); ++i)
      if (!matched_[i])
        idle.push_back(
            ofRule(golden_, rules[i], {},
                   "the tolerance rule '" + rules[i].pattern + "' matches no value; remove or correct the rule"));
    for (auto& [line, difference] : blind_) idle.push_back(std::move(difference));
    results.push_back(resultOf("tolerances", std::move(idle), rules.size()));
  }
  void addResults(std::vector<CheckResult>& results) {
    for (RuleCheck& check : checks_)
      if (check.values > 0) results.push_back(std::move(check).result());
  }

 private:
  const Golden& golden_;
  std::vector<RuleCheck> checks_;  // the last one is for numbers without a rule
  std::vector<bool> matched_;
  std::map<int, Difference> blind_;  // rules that apply beyond the horizon, by line
};

/// Compares two rows of one key: numbers by the rules, other values as texts. A column that the golden lacks joined the
/// table later and is not compared.
void compareRows(const Golden& golden, const GoldenRow& expected, const GoldenRow* actual, NumberComparison& numbers,
                 std::vector<Difference>& differences) {
  std::map<std::string, std::string> now;
  if (actual)
    for (const RowValue& value : valuesOf(*actual)) now.emplace(value.column, value.text);
  for (const RowValue& value : valuesOf(expected)) {
    const auto found = now.find(value.column);
    const auto number = readReal(value.text);
    const auto is = found == now.end() ? std::nullopt : readReal(found->second);
    if (number)
      numbers.add({expected.name + '/' + value.column, expected.step, *number}, is, expected.line, {}, value.column);
    if (!actual || (number && is) || (found != now.end() && found->second == value.text)) continue;
    const std::string isText = found == now.end() ? "no such column" : found->second;
    const std::string place = placeIn(golden, expected.line);
    differences.push_back({place,
                           expected.step,
                           {},
                           value.column,
                           value.text,
                           isText,
                           place + ": " + expected.name + ": " + value.column + ": expected '" + value.text +
                               "', actual '" + isText + "'" +
                               (isText == "-" || value.text == "-" ? " (- is not measured)" : "")});
  }
}

}  // namespace

CheckResult resultOf(const std::string& check, std::vector<Difference> differences, std::size_t items) {
  CheckResult r{.check = check, .kind = CheckKind::golden, .passed = differences.empty()};
  if (r.passed) {
    r.expected = r.actual = std::to_string(items) + (items == 1 ? " item" : " items");
    return r;
  }
  sortByStep(differences);
  const Difference& first = differences.front();
  r.expected = first.expected;
  r.actual = first.actual;
  r.firstStep = first.step;
  r.cell = first.cell;
  r.field = first.field;
  r.message = listed(differences);
  return r;
}

void compareNumbers(const Golden& golden, const ItemPairs& values, const ItemPairs& tables,
                    std::vector<CheckResult>& results) {
  NumberComparison numbers(golden);
  std::vector<Difference> unpaired, others;
  for (const ItemPair& pair : values) {
    const auto* value = pair.golden ? &std::get<GoldenValue>(*pair.golden) : nullptr;
    const auto* now = pair.observed ? &std::get<GoldenValue>(*pair.observed) : nullptr;
    const bool both = value && now && now->step == value->step;
    if (!both || value->value.has_value() != now->value.has_value())
      unpaired.push_back(*findDifference(golden.file, pair.golden, pair.observed));
    if (value)
      numbers.add({goldenText(value->name), value->step, value->value.value_or(0)},
                  both && value->value ? now->value : std::nullopt, value->line, cellOf(*pair.golden),
                  value->name.measure);
  }

  // If only one of run and golden has few enough rows to hold them by value, only the columns are compared.
  std::map<std::string, int> byValue;
  for (const ItemPair& pair : tables)
    for (const GoldenItem* item : {pair.golden, pair.observed})
      if (const auto* row = item ? std::get_if<GoldenRow>(item) : nullptr)
        byValue[tableOf(row->name)] |= item == pair.golden ? 1 : 2;
  for (const ItemPair& pair : tables) {
    const GoldenItem& item = pair.golden ? *pair.golden : *pair.observed;
    const auto* row = std::get_if<GoldenRow>(&item);
    if (row && byValue[tableOf(row->name)] != 3) {
      if (pair.golden) compareRows(golden, *row, nullptr, numbers, others);
      continue;
    }
    if (row && pair.golden)
      compareRows(golden, *row, pair.observed ? &std::get<GoldenRow>(*pair.observed) : nullptr, numbers, others);
    if (row && pair.golden && pair.observed && std::get<GoldenRow>(*pair.observed).step == row->step) continue;
    if (auto difference = findDifference(golden.file, pair.golden, pair.observed))
      others.push_back(std::move(*difference));
  }

  numbers.addTolerances(results);
  if (!values.empty() || !golden.rules.empty())
    results.push_back(resultOf("completeness", std::move(unpaired), values.size()));
  numbers.addResults(results);
  if (!tables.empty()) results.push_back(resultOf("tables", std::move(others), tables.size()));
}

}  // namespace morula
