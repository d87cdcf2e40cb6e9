// Compares a run with its golden, check by check.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "files/text.h"
#include "golden/change.h"
#include "golden/compare_numbers.h"
#include "golden/difference.h"
#include "golden/read_number.h"
#include "golden/toleranced_numbers.h"

namespace morula {
namespace {

/// Recognises values and columns of measures that were added after the golden was accepted. For a value, the golden has
/// others of the same cell and time, and none of this measure. For a column, the golden has others of the same table.
class JoinedLater {
 public:
  explicit JoinedLater(const Golden& golden) {
    for (const auto* value : all<GoldenValue>(golden.data))
      of_.insert(ofWhat(value->name)), measures_.insert(value->name.measure);
    for (const auto* column : all<GoldenColumn>(golden.data)) tables_.insert(tableOf(column->name));
  }
  bool operator()(const GoldenItem& item) const {
    if (const auto* column = std::get_if<GoldenColumn>(&item)) return tables_.contains(tableOf(column->name));
    const auto* value = std::get_if<GoldenValue>(&item);
    return value && of_.contains(ofWhat(value->name)) && !measures_.contains(value->name.measure);
  }

 private:
  static ValueName ofWhat(const ValueName& name) { return {name.time, name.cell, ""}; }
  std::set<ValueName> of_;
  std::set<std::string> measures_, tables_;
};

/// Converts data to format 1, which holds 0 for values that were not measured.
GoldenData asInFormat1(GoldenData data) {
  for (GoldenItem& item : data.items)
    if (auto* value = std::get_if<GoldenValue>(&item)) value->value = value->value.value_or(0);
  return data;
}

std::map<std::string, ItemPairs> pairUp(const Golden& golden, const GoldenData& observed) {
  std::map<std::string, const GoldenItem*> open;
  for (const GoldenItem& item : observed.items) open.emplace(idOf(item), &item);
  std::map<std::string, ItemPairs> checks;
  for (const GoldenItem& item : golden.data.items) {
    ItemPair pair{&item, nullptr};
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

CheckResult compareExactly(const std::string& file, const std::string& check, const ItemPairs& pairs) {
  std::vector<Difference> differences;
  for (const ItemPair& p : pairs)
    if (auto d = findDifference(file, p.golden, p.observed)) differences.push_back(std::move(*d));
  CheckResult r = resultOf(check, std::move(differences), pairs.size());
  if (pairs.size() == 1 && r.passed) {
    const auto last = [&](const std::string&, const auto& value) { r.expected = r.actual = goldenText(value); };
    std::visit([&](const auto& only) { visitGoldenFields(last, only); }, *pairs.front().golden);
  }
  return r;
}

/// Pictures of another renderer may differ by rounding, so only those of the same renderer are compared.
CheckResult compareImages(const std::string& file, ItemPairs pairs) {
  const std::size_t all = pairs.size();
  bool undrawn = false;
  std::erase_if(pairs, [&](const ItemPair& p) {
    if (!p.golden || !p.observed) return false;
    const std::string& now = std::get<GoldenImage>(*p.observed).renderer;
    undrawn |= now == GoldenImage::undrawn;
    return std::get<GoldenImage>(*p.golden).renderer != now;
  });
  CheckResult r = compareExactly(file, "images", pairs);
  if (r.passed && pairs.size() < all)
    r.actual = std::string(notCompared) + (undrawn ? "the run draws no picture" : "another renderer drew the picture");
  return r;
}

/// Compares the chain of hashes. Reports only the first link that differs, with the cells whose hashes differ there,
/// because all later links must differ, too.
CheckResult compareChain(const Golden& golden, const ItemPairs& pairs) {
  CheckResult r = compareExactly(golden.file, "step_hashes", pairs);
  r.message = firstLine(r.message);
  for (const ItemPair& p : pairs) {
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
  compare("scenario", golden.data.scenario, observed.scenario, "the golden belongs to another scenario");
  const auto keys = changedKeys(golden.data, observed);
  for (const KeyChange& c : keys)
    compare(c.key.c_str(), c.before, c.after, "the scenario has changed since this golden was accepted");
  if (keys.empty())
    compare("scenario_hash", golden.data.scenarioHash, observed.scenarioHash,
            "the scenario has changed since this golden was accepted");
  compare("seed", std::to_string(golden.data.seed), std::to_string(observed.seed),
          "the run has another seed than the golden");
  CheckResult r = resultOf("scenario", std::move(differences), 1);
  r.firstStep.reset();
  if (r.passed) r.expected = r.actual = golden.data.scenarioHash;
  return r;
}

/// Returns the result for a golden without recorded tables: only an old golden may lack them.
CheckResult withoutTables(const Golden& golden) {
  const std::string remedy =
      "look at the result, and if it is right, accept it with `morula review SCENARIO --accept --why \"…\"`";
  if (golden.version > 1)
    return failedCheck("tables", FailureClass::inputChanged, "recorded tables", "none in the golden",
                       golden.file + ": the golden holds none of the tables that the run records; " + remedy);
  return {.check = "tables",
          .kind = CheckKind::golden,
          .actual = std::string(notCompared) +
                    "recorded tables (contacts, divisions, measures on demand, …), since the golden is of format 1 and "
                    "holds none of them; to have them checked, " +
                    remedy};
}

/// Sets the class of each failed check. An earlier cause explains later ones: a changed scenario, then the state before
/// the first step, then the lineage. Other failures are changes of the computation.
void classify(std::vector<CheckResult>& results) {
  std::set<std::string> failed;
  for (const CheckResult& r : results)
    if (!r.passed) failed.insert(r.check);
  const bool costsAlone = failed == std::set<std::string>{"costs"};
  const bool imagesAlone = failed == std::set<std::string>{"images"};
  const auto isRecord = [](const std::string& check) { return check == "tables" || check.starts_with("values"); };
  const bool recordsAlone = failed.contains("tables") && std::ranges::all_of(failed, isRecord);
  FailureClass cause = FailureClass::computation;
  if (failed.contains("lineage")) cause = FailureClass::lineage;
  for (const CheckResult& r : results)
    if (!r.passed && r.firstStep == 0u && r.check != "lineage" && r.check != "completeness")
      cause = FailureClass::setup;
  if (failed.contains("scenario")) cause = FailureClass::inputChanged;
  for (CheckResult& r : results) {
    if (r.passed) continue;
    if (r.check == "tables" && r.failureClass != FailureClass::none) continue;  // withoutTables has set the class
    const bool aboutTheFile =
        r.check == "tolerances" || (r.check == "completeness" && cause == FailureClass::computation);
    const bool chaos = cause == FailureClass::computation && r.failureClass == FailureClass::chaos;
    r.failureClass = aboutTheFile   ? FailureClass::inputChanged
                     : costsAlone   ? FailureClass::cost
                     : imagesAlone  ? FailureClass::image
                     : recordsAlone ? FailureClass::record
                     : chaos        ? FailureClass::chaos
                                    : cause;
  }
}

}  // namespace

CheckReport unusableGolden(const std::string& scenario, const std::string& why) {
  return {scenario,
          {failedCheck("golden", FailureClass::inputChanged, "a golden file as it was accepted", "another", why)}};
}

CheckReport compareGolden(const Golden& golden, const GoldenData& observed) {
  CheckReport report{golden.data.scenario, {}};
  const GoldenData now = golden.version > 1 ? observed : asInFormat1(observed);
  std::map<std::string, ItemPairs> checks = pairUp(golden, now);
  report.results.push_back(compareScenario(golden, observed));
  for (const std::string check : {"counts", "lineage", "time_steps", "bits", "step_hashes", "images", "costs"}) {
    const auto found = checks.find(check);
    if (found == checks.end()) continue;
    report.results.push_back(check == "step_hashes" ? compareChain(golden, found->second)
                             : check == "images"    ? compareImages(golden.file, found->second)
                                                    : compareExactly(golden.file, check, found->second));
  }
  const auto isOfTable = [](const GoldenItem& item) { return checkOf(item) == "tables"; };
  const bool holdsTables = std::ranges::any_of(golden.data.items, isOfTable);
  if (!holdsTables) checks.erase("tables");
  compareNumbers(golden, checks["values"], checks["tables"], report.results);
  if (!holdsTables && std::ranges::any_of(observed.items, isOfTable)) report.results.push_back(withoutTables(golden));
  classify(report.results);
  if (!report.passed()) report.change = changeInWords(golden.data, observed);
  return report;
}

}  // namespace morula
