#include "analysis/margins.h"

#include <algorithm>
#include <cmath>

#include "analysis/measure_words.h"
#include "base/did_you_mean.h"
#include "files/text.h"
#include "golden/read_number.h"
#include "system/usage_error.h"

namespace morula {
namespace {

constexpr const char* forms =
    "a number above 0 as 0.01, a share of the mean as 5%, or either of one measure as sphericity=0.01";

Margin parseMargin(const std::string& word, const std::vector<std::string>& measures) {
  Margin margin;
  std::string size = word;
  if (const auto sign = word.find('='); sign != word.npos) {
    margin.measure = nameAmong("--equivalent", "measure", word.substr(0, sign), measures);
    size = word.substr(sign + 1);
  }
  margin.ofMean = size.ends_with("%");
  if (margin.ofMean) size.pop_back();
  const auto value = readReal(size);
  if (!value || !(*value > 0) || !std::isfinite(*value))
    throw UsageError("--equivalent: '" + word + "' is no margin; needs " + forms);
  margin.size = margin.ofMean ? *value / 100 : *value;
  return margin;
}

}  // namespace

std::vector<Margin> parseMargins(const std::vector<std::string>& words, const std::vector<std::string>& measures) {
  std::vector<Margin> margins;
  for (const std::string& word : words) {
    Margin margin = parseMargin(word, measures);
    if (std::ranges::any_of(margins, [&](const Margin& m) { return m.measure == margin.measure; }))
      throw UsageError("--equivalent: " +
                       (margin.measure.empty() ? "two margins for all measures" : "two margins for " + margin.measure) +
                       "; leave out one of them");
    margins.push_back(std::move(margin));
  }
  return margins;
}

std::optional<double> marginOf(const std::vector<Margin>& margins, const std::string& measure, double mean) {
  const Margin* found = nullptr;
  for (const Margin& m : margins)
    if (m.measure == measure || (m.measure.empty() && !found)) found = &m;
  if (!found) return std::nullopt;
  const double size = found->ofMean ? found->size * std::abs(mean - wordsOfMeasure(measure).zero) : found->size;
  return size > 0 ? std::optional(size) : std::nullopt;
}

std::string nameAmong(const std::string& option, const std::string& kind, std::string word,
                      const std::vector<std::string>& names) {
  if (std::ranges::find(names, word) != names.end()) return word;
  const std::string typed = word;
  std::ranges::replace(word, '-', '_');
  if (std::ranges::find(names, word) != names.end()) return word;
  const std::string near = closest(word, names);
  throw UsageError(option + ": the study has no " + kind + " '" + typed + "'; " +
                   (!near.empty()   ? "did you mean " + near + "?"
                    : names.empty() ? "needs a measure of the study, which has none"
                                    : "it has " + join(names)));
}

}  // namespace morula
