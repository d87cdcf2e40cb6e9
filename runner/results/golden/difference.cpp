#include "golden/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/cell_path.h"
#include "golden/read_number.h"

namespace morula {
namespace {

constexpr std::size_t maxTold = 9;  // max number of differences that are listed

std::string hex(double value) { return fmt::format("{:#018x}", std::bit_cast<std::uint64_t>(value)); }

/// Returns an item's name for people: "cell AB", "the egg", "count divisions".
std::string nameOf(const GoldenItem& item) {
  if (std::holds_alternative<GoldenValue>(item)) return keyOf(item);
  if (const auto* cell = std::get_if<GoldenCell>(&item); cell && cell->path.isEgg()) return "the egg";
  return idOf(item);
}

/// Returns the step at which two lives of one cell part: at birth, or else at the earlier end. Absent if both are
/// alive: their states then part at an unknown step after birth.
std::optional<std::uint64_t> partingStep(const GoldenCell& golden, const GoldenCell& observed,
                                         const std::string& field) {
  if (field.starts_with("born")) return std::min(golden.bornStep, observed.bornStep);
  if (!golden.endedStep || !observed.endedStep) return golden.endedStep ? golden.endedStep : observed.endedStep;
  return std::min(*golden.endedStep, *observed.endedStep);
}

template <class Value>
std::string inWords(const Value& expected, const Value& actual) {
  return "expected '" + goldenText(expected) + "', actual '" + goldenText(actual) + "'";
}
std::string inWords(double expected, double actual) { return compareInWords(expected, actual); }
std::string inWords(const std::optional<double>& expected, const std::optional<double>& actual) {
  if (expected && actual) return compareInWords(*expected, *actual);
  return inWords<std::optional<double>>(expected, actual);
}

constexpr std::size_t digits = 4;  // digits of each cell's hash in a line `step_hash`

/// Returns the cells alive after this step according to the golden's lineage, by lineage path.
std::vector<CellPath> aliveAt(const GoldenData& golden, std::uint64_t step) {
  std::vector<CellPath> alive;
  for (const auto* cell : all<GoldenCell>(golden))
    if (cell->bornStep <= step && (!cell->endedStep || *cell->endedStep > step)) alive.push_back(cell->path);
  std::sort(alive.begin(), alive.end());
  return alive;
}

}  // namespace

std::string compareInWords(double expected, double actual) {
  constexpr std::uint64_t near = 1 << 20;  // [ulp] larger differences are not told in bits
  const std::uint64_t ulps = ulpsBetween(expected, actual);
  if (ulps > near && std::isfinite(expected) && std::isfinite(actual))
    return "expected " + exactText(expected) + ", actual " + exactText(actual) + ", difference " +
           numberText(actual - expected, 3) +
           (expected != 0 ? " (" + numberText(100 * (actual - expected) / std::abs(expected), 3) + " %)" : "");
  std::string text = "expected " + exactText(expected) + " (" + hex(expected) + "), actual " + exactText(actual) +
                     " (" + hex(actual) + ")";
  if (ulps == std::numeric_limits<std::uint64_t>::max()) return text;  // one of the numbers is NaN
  return text + ", " + std::to_string(ulps) + (ulps == 1 ? " ulp" : " ulps") + " apart, difference " +
         exactText(actual - expected);
}

std::optional<Difference> findDifference(const std::string& file, const GoldenItem* golden,
                                         const GoldenItem* observed) {
  const GoldenItem& item = golden ? *golden : *observed;
  Difference d;
  d.place = golden ? file + ':' + std::to_string(std::visit([](const auto& i) { return i.line; }, *golden)) : file;
  d.cell = cellOf(item);
  d.step = stepOf(item);
  if (!golden || !observed) {
    (golden ? d.expected : d.actual) = write(item);
    d.text = d.place + ": " + nameOf(item) +
             (golden ? ": the golden has this item, but the run does not: `"
                     : ": the run has this item, but the golden does not: `") +
             write(item) + '`';
    return d;
  }
  const auto compare = [&]<class Item>(const Item& e) {
    const Item& a = std::get<Item>(*observed);
    const auto compareField = [&](const std::string& field, const auto& x, const auto& y) {
      if (!d.field.empty() || agree(x, y)) return;
      d.field = field, d.expected = goldenText(x), d.actual = goldenText(y);
      if constexpr (std::is_same_v<Item, GoldenCell>) d.step = partingStep(e, a, field);
      d.text = d.place + ": " + nameOf(item) + ": " +
               (field == "hash" ? "the hash differs from the accepted one" : field + ": " + inWords(x, y));
    };
    visitGoldenFields(compareField, e, a);
  };
  std::visit(compare, *golden);
  return d.field.empty() ? std::nullopt : std::optional(d);
}

void sortByStep(std::vector<Difference>& differences) {
  std::stable_sort(differences.begin(), differences.end(), [](const Difference& a, const Difference& b) {
    constexpr auto last = std::numeric_limits<std::uint64_t>::max();
    return a.step.value_or(last) < b.step.value_or(last);
  });
}

std::string listed(const std::vector<Difference>& differences) {
  std::string text;
  for (std::size_t i = 0; i < std::min(maxTold, differences.size()); ++i) text += (i ? "\n" : "") + differences[i].text;
  if (differences.size() > maxTold) text += "\nand " + std::to_string(differences.size() - maxTold) + " more";
  return text;
}

std::vector<std::string> cellsThatDiffer(const GoldenData& golden, const GoldenLink& expected,
                                         const GoldenLink& actual) {
  const std::string &e = expected.cells.text, &a = actual.cells.text;
  const std::vector<CellPath> alive = aliveAt(golden, expected.step);
  std::vector<std::string> cells;
  if (e.size() != a.size() || e.size() != digits * alive.size()) return cells;  // the cells are not those of the golden
  for (std::size_t i = 0; i < alive.size(); ++i)
    if (e.compare(digits * i, digits, a, digits * i, digits) != 0) cells.push_back(alive[i].text());
  return cells;
}

std::string inWords(const std::vector<std::string>& cells) {
  std::string text;
  for (std::size_t i = 0; i < std::min(maxTold, cells.size()); ++i)
    text += (i ? ", " : "") + (cells[i].empty() ? "the egg" : cells[i]);
  if (cells.size() > maxTold) text += " and " + std::to_string(cells.size() - maxTold) + " more";
  return text;
}

}  // namespace morula
