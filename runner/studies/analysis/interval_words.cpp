// Sentences on intervals: what they assume, and how often they hold.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/compare_parts.h"
#include "statistics/coverage.h"

namespace morula {
namespace {

/// Counts intervals of means and of differences, those of each shape, and the fewest runs of one.
struct Intervals {
  std::size_t all = 0, skewed = 0, twoGroups = 0, fewest = SIZE_MAX;

  void add(const std::optional<Interval>& interval, SampleShape shape, std::size_t n) {
    if (!interval) return;
    ++all, skewed += shape == SampleShape::skewed, twoGroups += shape == SampleShape::twoGroups;
    fewest = std::min(fewest, n);
  }
};

std::string ofIntervals(std::size_t some, std::size_t all) {
  return fmt::format("{} of {} interval{}", some, all, all == 1 ? "" : "s");
}

}  // namespace

void addIntervals(const StudyComparison& c, std::vector<std::string>& verdicts) {
  Intervals found;
  for (const ConditionSummary& s : c.conditions) found.add(s.interval, s.shape, s.distinct);
  for (const PairComparison& p : c.pairs) found.add(p.paired.interval, p.paired.sample.shape, p.of.size());
  if (found.skewed > 0)
    verdicts.push_back(fmt::format(
        "skewed: a few values lie far out on one side in the samples of {}, which reach farther on that side than "
        "Student's",
        ofIntervals(found.skewed, found.all)));
  if (found.twoGroups > 0)
    verdicts.push_back(fmt::format(
        "two groups: values lie in two groups in the samples of {}, which are those of the share of runs in each group",
        ofIntervals(found.twoGroups, found.all)));
  const auto coverage = found.all > 0 ? coverageOf(found.fewest) : std::nullopt;
  if (!coverage || std::min({coverage->exponential, coverage->logNormal, coverage->oneInTen}) >= 93) return;
  verdicts.push_back(fmt::format(
      "intervals: with {} runs a 95 % interval holds the mean in {} of 100 studies if values are normal, in {} if they "
      "are exponential, in {} if they are log-normal, and in {} if one run in ten ends far from all others; so few runs "
      "need not show which it is",
      found.fewest, coverage->normal, coverage->exponential, coverage->logNormal, coverage->oneInTen));
}

}  // namespace morula
