#include "golden/difference.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <limits>

#include "base/cell_path.h"
#include "golden/number_text.h"

namespace morula {

namespace {

constexpr std::size_t mostTold = 9;  // told one by one

std::string hex(double value) {
  char digits[16];
  const auto end = std::to_chars(digits, digits + 16, std::bit_cast<std::uint64_t>(value), 16).ptr;
  const std::string text(digits, end);
  return "0x" + std::string(16 - text.size(), '0') + text;
}

/// "cell AB", "egg", "count divisions": what people call an item.
std::string nameOf(const GoldenItem& item) {
  if (item.kind == "value") return item.key;
  if (item.kind == "cell" && item.key == "egg") return "the egg";
  return item.kind + ' ' + item.key;
}

/// The step at which two lives of one cell part: at birth, or else at the earlier of the two ends.
std::optional<std::uint64_t> partingStep(const GoldenItem& golden, const GoldenItem& observed,
                                         std::size_t field) {
  if (golden.kind != "cell") return stepOf(golden);
  constexpr std::size_t bornStep = 1, endedStep = 3;
  const std::size_t which = field <= bornStep ? bornStep : endedStep;
  std::optional<std::uint64_t> first;
  for (const GoldenItem* item : {&golden, &observed})
    if (const auto step = readNatural(item->fields[which]); step && (!first || *step < *first)) first = step;
  return first;  // none: both alive, so the states part somewhere after their birth
}

std::string inWords(FieldType type, const std::string& expected, const std::string& actual) {
  const auto e = readReal(expected), a = readReal(actual);
  if (type == FieldType::real && e && a) return compareInWords(*e, *a);
  return "expected '" + expected + "', actual '" + actual + "'";
}

constexpr std::size_t digits = 4;  // of a cell's hash

/// Who was alive after this step, by lineage path, as the golden's lineage tells.
std::vector<CellPath> aliveAt(const GoldenData& golden, std::uint64_t step) {
  std::vector<CellPath> alive;
  for (const GoldenItem& item : golden.items) {
    if (item.kind != "cell") continue;
    const auto born = readNatural(item.fields[1]), ended = readNatural(item.fields[3]);
    if (born && *born <= step && (!ended || *ended > step))
      alive.push_back(item.key == "egg" ? CellPath{} : CellPath::parse(item.key));
  }
  std::sort(alive.begin(), alive.end());
  return alive;
}

}  // namespace

std::string compareInWords(double expected, double actual) {
  const std::uint64_t ulps = ulpsBetween(expected, actual);
  std::string text = "expected " + exactText(expected) + " (" + hex(expected) + "), actual " +
                     exactText(actual) + " (" + hex(actual) + ")";
  if (ulps == std::numeric_limits<std::uint64_t>::max()) return text;  // not a number
  return text + ", " + std::to_string(ulps) + (ulps == 1 ? " ulp" : " ulps") + " apart, difference " +
         exactText(actual - expected);
}

std::optional<Difference> findDifference(const std::string& file, const GoldenItem* golden,
                                         const GoldenItem* observed) {
  const GoldenItem& item = golden ? *golden : *observed;
  Difference d;
  d.place = golden ? file + ':' + std::to_string(golden->line) : file;
  d.cell = cellOf(item);
  if (!golden || !observed) {
    d.step = stepOf(item);
    (golden ? d.expected : d.actual) = write(item);
    d.text = d.place + ": " + nameOf(item) +
             (golden ? ": expected, but the run has none: `" : ": the run has it, the golden does not: `") +
             write(item) + '`';
    return d;
  }
  const ItemForm& form = *findForm(item.kind);
  for (std::size_t i = 0; i < form.fields.size(); ++i) {
    if (golden->fields[i] == observed->fields[i]) continue;
    d.field = form.fields[i].name;
    d.step = partingStep(*golden, *observed, i);
    d.expected = golden->fields[i];
    d.actual = observed->fields[i];
    d.text = d.place + ": " + nameOf(item) + ": " + d.field + ": " +
             inWords(form.fields[i].type, d.expected, d.actual);
    return d;
  }
  return std::nullopt;
}

void sortByStep(std::vector<Difference>& differences) {
  std::stable_sort(differences.begin(), differences.end(), [](const Difference& a, const Difference& b) {
    constexpr auto last = std::numeric_limits<std::uint64_t>::max();
    return a.step.value_or(last) < b.step.value_or(last);
  });
}

std::string listed(const std::vector<Difference>& differences) {
  std::string text;
  for (std::size_t i = 0; i < std::min(mostTold, differences.size()); ++i)
    text += (i ? "\n" : "") + differences[i].text;
  if (differences.size() > mostTold)
    text += "\nand " + std::to_string(differences.size() - mostTold) + " more";
  return text;
}

std::vector<std::string> cellsThatDiffer(const GoldenData& golden, const GoldenItem& expected,
                                         const GoldenItem& actual) {
  const std::string &e = expected.fields[1], &a = actual.fields[1];
  const std::vector<CellPath> alive = aliveAt(golden, stepOf(expected).value_or(0));
  std::vector<std::string> cells;
  if (e.size() != a.size() || e.size() != digits * alive.size()) return cells;  // another population
  for (std::size_t i = 0; i < alive.size(); ++i)
    if (e.compare(digits * i, digits, a, digits * i, digits) != 0) cells.push_back(alive[i].text());
  return cells;
}

std::string inWords(const std::vector<std::string>& cells) {
  std::string text;
  for (std::size_t i = 0; i < std::min(mostTold, cells.size()); ++i)
    text += (i ? ", " : "") + (cells[i].empty() ? "the egg" : cells[i]);
  if (cells.size() > mostTold) text += " and " + std::to_string(cells.size() - mostTold) + " more";
  return text;
}

}  // namespace morula
