// Margins of equivalence that are wider than all that was seen: no two conditions could fail them.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/compare_parts.h"
#include "base/number_text.h"
#include "system/usage_error.h"

namespace morula {

ValueRange rangeOf(const StudyComparison& c, std::size_t measure) {
  ValueRange range;
  for (const ConditionSummary& s : c.conditions)
    if (s.measure == measure)
      for (const double v : s.values) range.low = std::min(range.low, v), range.high = std::max(range.high, v);
  return range;
}

bool isTooWide(const ValueRange& range, double margin) {
  const double width = range.high - range.low;
  return width > onePathSpread * std::max(std::abs(range.low), std::abs(range.high)) && margin >= width;
}

std::string tooWideText(const StudyComparison& c, std::size_t measure, double margin) {
  const ValueRange range = rangeOf(c, measure);
  return fmt::format("±{} of {} is wider than the range of all its values ({} to {}), so any two conditions would pass",
                     numberText(margin, 3), c.measureName(measure), numberText(range.low), numberText(range.high));
}

std::string narrowerText(const StudyComparison& c, std::size_t measure) {
  const ValueRange range = rangeOf(c, measure);
  return "needs a margin below " + numberText(range.high - range.low, 2);
}

void refuseWideMargins(const StudyComparison& c) {
  for (const PairComparison& pair : c.pairs) {
    const std::string& name = c.measureName(pair.measure);
    const bool isItsOwn = std::ranges::find(c.margins, name, &Margin::measure) != c.margins.end();
    if (!isItsOwn || !pair.equivalence || pair.equivalence->verdict != Equivalent::untested) continue;
    throw UsageError("--equivalent: " + tooWideText(c, pair.measure, pair.equivalence->test.margin) + "; " +
                     narrowerText(c, pair.measure));
  }
}

}  // namespace morula
