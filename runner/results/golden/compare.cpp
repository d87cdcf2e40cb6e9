// Compares a run with its golden, check by check.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "files/text.h"
#include "golden/change.h"
#include "golden/difference.h"
#include "golden/number_text.h"

namespace morula {
namespace {

/// An item of the golden and the same item of the run; null if one of them does not have it.
struct Pair {
  const GoldenItem* golden = nullptr;
  const GoldenItem* observed = nullptr;
};

/// The pairs of one check, in the golden's order, then the items that only the run has.
using Pairs = std::vector<Pair>;

/// Recognises values of measures that were added to their table after the golden was accepted: the golden has other
/// values of the same cell and time, and no value of this measure anywhere.
class JoinedLater {
 public:
  explicit JoinedLater(const Golden& golden) {
    for (const auto* value : all<GoldenValue>(golden.data))
      of_.insert(ofWhat(value->name)), measures_.insert(value->name.measure);
  }
  bool operator()(const GoldenItem& item) const {
    const auto* value = std::get_if<GoldenValue>(&item);
    return value && of_.contains(ofWhat(value->name)) && !measures_.contains(value->name.measure);
  }

 private:
  static ValueName ofWhat(const ValueName& name) { return {name.time, name.cell, ""}; }
  std::set<ValueName> of_;
  std::set<std::string> measures_;
};

std::map<std::string, Pairs> pairUp(const Golden& golden, const GoldenData& observed) {
  std::map<std::string, const GoldenItem*> open;
  for (const GoldenItem& item : observed.items) open.emplace(idOf(item), &item);
  std::map<std::string, Pairs> checks;
  for (const GoldenItem& item : golden.data.items) {
    Pair pair{&item, nullptr};
    if (const auto found = open.find(idOf(item)); found != open.end()) {
      pair.observed = found->second;
      open.erase(found);
    }
    checks[checkOf(item)].push_back(pair);
  }
  const JoinedLater joinedLater(golden);
  for (const GoldenItem& item : observed.items)
    if (open.contains(idOf(item)) && !joinedLater(item)) checks[checkOf(item)].push_back({nullptr, &item});
  return checks;
}

/// The result of a check with `items` items, among which these differences were found.
CheckResult resultOf(const std::string& check, std::vector<Difference> differences, std::size_t items) {
  CheckResult r{.check = check, .kind = "golden", .passed = differences.empty()};
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

CheckResult compareExactly(const std::string& file, const std::string& check, const Pairs& pairs) {
  std::vector<Difference> differences;
  for (const Pair& p : pairs)
    if (auto d = findDifference(file, p.golden, p.observed)) differences.push_back(std::move(*d));
  CheckResult r = resultOf(check, std::move(differences), pairs.size());
  if (pairs.size() == 1 && r.passed) {
    const auto last = [&](const std::string&, const auto& value) { r.expected = r.actual = goldenText(value); };
    std::visit([&](const auto& only) { visitGoldenFields(last, only); }, *pairs.front().golden);
  }
  return r;
}

/// Pictures of another renderer may differ by rounding, so only those of the same renderer are compared.
CheckResult compareImages(const std::string& file, Pairs pairs) {
  const std::size_t all = pairs.size();
  bool undrawn = false;
  std::erase_if(pairs, [&](const Pair& p) {
    if (!p.golden || !p.observed) return false;
    const std::string& now = std::get<GoldenImage>(*p.observed).renderer;
    undrawn |= now == GoldenImage::undrawn;
    return std::get<GoldenImage>(*p.golden).renderer != now;
  });
  CheckResult r = compareExactly(file, "images", pairs);
  if (r.passed && pairs.size() < all) r.actual = undrawn ? "not drawn: not compared" : "another renderer: not compared";
  return r;
}

/// Compares the chain of hashes. Reports only the first link that differs, with the cells whose hashes differ there,
/// because all later links must differ, too.
CheckResult compareChain(const Golden& golden, const Pairs& pairs) {
  CheckResult r = compareExactly(golden.file, "step_hashes", pairs);
  r.message = firstLine(r.message);
  for (const Pair& p : pairs) {
    if (!p.golden || !p.observed || agree(*p.golden, *p.observed)) continue;
    const auto& expected = std::get<GoldenLink>(*p.golden);
    const auto cells = cellsThatDiffer(golden.data, expected, std::get<GoldenLink>(*p.observed));
    if (cells.empty()) break;
    r.cell = cells.front();
    r.message += "\ncells that differ at step " + std::to_string(expected.step) + ": " + inWords(cells);
    break;
  }
  return r;
}

CheckResult compareScenario(const Golden& golden, const GoldenData& observed) {
  std::vector<Difference> differences;
  const auto compare = [&](const char* field, const std::string& expected, const std::string& actual,
                           const char* what) {
    const std::string text = ": expected '" + expected + "', actual '" + actual + "': " + what;
    if (expected != actual)
      differences.push_back({golden.file, 0, {}, field, expected, actual, golden.file + ": " + field + text});
  };
  compare("scenario", golden.data.scenario, observed.scenario, "this is another scenario's golden");
  const auto keys = changedKeys(golden.data, observed);
  for (const KeyChange& c : keys)
    compare(c.key.c_str(), c.before, c.after, "the scenario has changed since this golden was accepted");
  if (keys.empty())
    compare("scenario_hash", golden.data.scenarioHash, observed.scenarioHash,
            "the scenario has changed since this golden was accepted");
  compare("seed", std::to_string(golden.data.seed), std::to_string(observed.seed), "the run has another seed");
  CheckResult r = resultOf("scenario", std::move(differences), 1);
  r.firstStep.reset();
  if (r.passed) r.expected = r.actual = golden.data.scenarioHash;
  return r;
}

/// The values to which one rule applies (null: no rule, so they must be exact).
struct RuleCheck {
  const ToleranceRule* rule = nullptr;
  std::vector<Difference> differences;
  std::size_t values = 0;
  double share = 0;                    // the largest
  const GoldenValue* worst = nullptr;  // the value with the largest share
  bool chaos = true;                   // every difference may have grown from one unit in the last place

  void add(const Golden& golden, const Pair& pair) {
    const std::string& file = golden.file;
    const Tolerance tolerance = rule ? rule->tolerance : Tolerance{};
    const auto& expected = std::get<GoldenValue>(*pair.golden);
    const double e = expected.value, a = std::get<GoldenValue>(*pair.observed).value;
    const double used = tolerance.share(e, a);
    ++values;
    if (!worst || used > share) share = used, worst = &expected;
    if (used <= 1) return;
    const double grown = grownBy(golden, expected.step) * std::max(std::abs(e), 1.0);
    chaos = chaos && grown > 0 && std::abs(a - e) <= grown;
    Difference d = *findDifference(file, pair.golden, pair.observed);
    d.field = expected.name.measure;
    d.text = d.place + ": " + goldenText(expected.name) + " at step " + std::to_string(expected.step) + ": " +
             compareInWords(e, a) + "; tolerance " + tolerance.text();
    if (tolerance.kind != Tolerance::Kind::exact) d.text += ", used " + exactText(used) + " times";
    if (rule) d.text += " (" + file + ':' + std::to_string(rule->line) + ')';
    differences.push_back(std::move(d));
  }

  CheckResult result() && {
    CheckResult r = resultOf(rule ? "values " + rule->pattern : "values", std::move(differences), values);
    if (!r.passed && chaos) r.failureClass = "CHAOS";
    if (!rule) return r;
    r.tolerance = rule->tolerance.text();
    if (rule->untilStep) r.tolerance += " until_step " + std::to_string(*rule->untilStep);
    if (rule->tolerance.kind == Tolerance::Kind::exact || !worst) return r;
    r.share = share;
    if (r.passed) {
      if (worst->name.cell) r.cell = worst->name.cell->text();
      r.field = worst->name.measure;
    }
    return r;
  }
};

/// What is wrong with a rule itself, in its line.
Difference ofRule(const Golden& golden, const ToleranceRule& rule, std::optional<std::uint64_t> step,
                  const std::string& what) {
  const std::string place = golden.file + ':' + std::to_string(rule.line);
  return {place, step, {}, "tolerance", rule.pattern, "", place + ": " + what};
}

/// Notes a rule that applies beyond the chaos horizon, where a difference in the last place alone exceeds its
/// tolerance, so that it tests nothing.
void noteHorizon(const Golden& golden, const ToleranceRule& rule, std::uint64_t step,
                 std::map<int, Difference>& blind) {
  const auto horizon = horizonOf(golden, rule.tolerance.size());
  if (rule.tolerance.kind == Tolerance::Kind::exact || !horizon || step < *horizon) return;
  const std::string what = "the rule '" + rule.pattern + "' allows " + rule.tolerance.text() + " at step " +
                           std::to_string(step) + ", but from step " + std::to_string(*horizon) +
                           " on one unit in the last place has grown to that: the chaos horizon; add until_step " +
                           std::to_string(*horizon - std::min<std::uint64_t>(*horizon, 1)) + " before why";
  blind.try_emplace(rule.line, ofRule(golden, rule, step, what));
}

void compareValues(const Golden& golden, const Pairs& pairs, std::vector<CheckResult>& results) {
  const std::vector<ToleranceRule>& rules = golden.rules;
  std::vector<RuleCheck> checks(rules.size() + 1);  // the last one is for values without a rule
  for (std::size_t i = 0; i < rules.size(); ++i) checks[i].rule = &rules[i];
  std::vector<bool> matched(rules.size(), false);
  std::vector<Difference> unpaired;
  std::map<int, Difference> blind;  // by line: rules that apply beyond the horizon

  for (const Pair& pair : pairs) {
    const auto* value = pair.golden ? &std::get<GoldenValue>(*pair.golden) : nullptr;
    const bool both = value && pair.observed && std::get<GoldenValue>(*pair.observed).step == value->step;
    if (!both) unpaired.push_back(*findDifference(golden.file, pair.golden, pair.observed));
    if (!value) continue;
    std::size_t holds = rules.size();
    for (std::size_t i = 0; i < rules.size(); ++i)
      if (rules[i].matches(goldenText(value->name), value->step)) matched[i] = true, holds = i;  // the last wins
    if (both) checks[holds].add(golden, pair);
    if (holds < rules.size()) noteHorizon(golden, rules[holds], value->step, blind);
  }

  std::vector<Difference> idle;
  for (std::size_t i = 0; i < rules.size(); ++i)
    if (!matched[i])
      idle.push_back(ofRule(golden, rules[i], {},
                            "the tolerance rule '" + rules[i].pattern + "' matches no value; remove or correct it"));
  for (auto& [line, difference] : blind) idle.push_back(std::move(difference));
  if (!rules.empty()) results.push_back(resultOf("tolerances", std::move(idle), rules.size()));
  results.push_back(resultOf("completeness", std::move(unpaired), pairs.size()));
  for (RuleCheck& check : checks)
    if (check.values > 0) results.push_back(std::move(check).result());
}

/// Sets the class of each failed check. An earlier cause explains later ones: a changed scenario, then the state before
/// the first step, then the lineage; other failures are changes of the computation.
void classify(std::vector<CheckResult>& results) {
  std::set<std::string> failed;
  for (const CheckResult& r : results)
    if (!r.passed) failed.insert(r.check);
  const bool costsAlone = failed == std::set<std::string>{"costs"};
  const bool imagesAlone = failed == std::set<std::string>{"images"};
  std::string cause = "COMPUTATION";
  if (failed.contains("lineage")) cause = "LINEAGE";
  for (const CheckResult& r : results)
    if (!r.passed && r.firstStep == 0u && r.check != "lineage" && r.check != "completeness") cause = "SETUP";
  if (failed.contains("scenario")) cause = "INPUT_CHANGED";
  for (CheckResult& r : results) {
    if (r.passed) continue;
    const bool aboutTheFile = r.check == "tolerances" || (r.check == "completeness" && cause == "COMPUTATION");
    const bool chaos = cause == "COMPUTATION" && r.failureClass == "CHAOS";
    r.failureClass = aboutTheFile  ? "INPUT_CHANGED"
                     : costsAlone  ? "COST"
                     : imagesAlone ? "IMAGE"
                     : chaos       ? "CHAOS"
                                   : cause;
  }
}

}  // namespace

CheckReport unusableGolden(const std::string& scenario, const std::string& why) {
  return {scenario, {failedCheck("golden", "INPUT_CHANGED", "a golden file as it was accepted", "another", why)}};
}

CheckReport compareGolden(const Golden& golden, const GoldenData& observed) {
  CheckReport report{golden.data.scenario, {}};
  std::map<std::string, Pairs> checks = pairUp(golden, observed);
  report.results.push_back(compareScenario(golden, observed));
  for (const std::string check : {"counts", "lineage", "time_steps", "bits", "step_hashes", "images", "costs"}) {
    const auto found = checks.find(check);
    if (found == checks.end()) continue;
    report.results.push_back(check == "step_hashes" ? compareChain(golden, found->second)
                             : check == "images"    ? compareImages(golden.file, found->second)
                                                    : compareExactly(golden.file, check, found->second));
  }
  if (checks.contains("values") || !golden.rules.empty()) compareValues(golden, checks["values"], report.results);
  classify(report.results);
  if (!report.passed()) report.change = changeInWords(golden.data, observed);
  return report;
}

}  // namespace morula
