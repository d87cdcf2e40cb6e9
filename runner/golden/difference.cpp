#include "golden/difference.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <limits>

#include "golden/number_text.h"

namespace morula {

namespace {

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
  constexpr std::size_t most = 9;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, differences.size()); ++i)
    text += (i ? "\n" : "") + differences[i].text;
  if (differences.size() > most) text += "\nand " + std::to_string(differences.size() - most) + " more";
  return text;
}

}  // namespace morula
