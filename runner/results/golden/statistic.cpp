#include "golden/statistic.h"

#include "golden/item.h"
#include "golden/number_text.h"

namespace morula {

std::string write(const GoldenStatistic& s) {
  return "statistic " + s.measure + " against " + s.against + " difference " + exactText(s.difference) + " low " +
         exactText(s.low) + " high " + exactText(s.high) + " runs " + std::to_string(s.runs);
}

std::optional<GoldenStatistic> readStatistic(std::string_view line) {
  GoldenStatistic s;
  bool isGood = true;
  const auto expect = [&](std::string_view word) { isGood &= takeWord(line) == word; };
  const auto name = [&] {
    const std::string word(takeWord(line));
    isGood &= !word.empty();
    return word;
  };
  const auto number = [&] {
    const auto value = readReal(takeWord(line));
    isGood &= value.has_value();
    return value.value_or(0);
  };
  expect("statistic");
  s.measure = name();
  expect("against");
  s.against = name();
  expect("difference");
  s.difference = number();
  expect("low");
  s.low = number();
  expect("high");
  s.high = number();
  expect("runs");
  const auto runs = readNatural(line);
  if (!isGood || !runs || *runs < 2 || !(s.low <= s.high)) return std::nullopt;
  s.runs = *runs;
  return s;
}

void add(Hasher& hasher, const GoldenStatistic& s) {
  hasher.field("statistic").add(s.measure).add(s.against).add(s.difference).add(s.low).add(s.high).add(s.runs);
}

}  // namespace morula
