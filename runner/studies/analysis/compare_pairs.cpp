// Comparison of two levels of an axis, seed by seed.
#include <algorithm>
#include <map>
#include <set>

#include "analysis/compare_parts.h"
#include "statistics/equivalence.h"

namespace morula {
namespace {

using Fixed = std::vector<std::optional<std::size_t>>;

/// Returns the pairs of conditions that differ in one axis alone: level `a` of it, and level `b`.
std::vector<std::pair<std::size_t, std::size_t>> partners(const StudyResults& results, std::size_t axis, std::size_t a,
                                                          std::size_t b, const Fixed& at) {
  std::map<std::vector<std::size_t>, std::size_t> byLevels;
  for (std::size_t i = 0; i < results.conditions.size(); ++i) byLevels[results.conditions[i].levels] = i;
  std::vector<std::pair<std::size_t, std::size_t>> all;
  for (std::size_t i = 0; i < results.conditions.size(); ++i) {
    auto levels = results.conditions[i].levels;
    bool fits = levels[axis] == a;
    for (std::size_t x = 0; x < levels.size(); ++x) fits = fits && (!at[x] || *at[x] == levels[x]);
    if (!fits) continue;
    levels[axis] = b;
    if (const auto partner = byLevels.find(levels); partner != byLevels.end()) all.push_back({i, partner->second});
  }
  return all;
}

/// Returns true if both sides of a difference in all pairs of runs are one path, or every pair is equal but for
/// rounding.
bool isOnePath(const PairComparison& pair, bool sidesAre) {
  if (pair.of.size() < 2 || sidesAre) return sidesAre;
  double largest = 0, apart = 0;
  for (std::size_t i = 0; i < pair.of.size(); ++i) {
    largest = std::max({largest, std::abs(pair.of[i]), std::abs(pair.against[i])});
    apart = std::max(apart, std::abs(pair.of[i] - pair.against[i]));
  }
  return apart > 0 && apart <= onePathSpread * largest;
}

PairComparison compare(const StudyComparison& c, std::size_t measure, std::size_t axis, std::size_t a, std::size_t b,
                       const Fixed& at) {
  const StudyResults& results = c.results;
  std::set<std::size_t> onePaths;  // conditions
  for (const ConditionSummary& s : c.conditions)
    if (s.measure == measure && (s.onePath || !results.conditions[s.condition].usesSeed)) onePaths.insert(s.condition);
  PairComparison pair;
  pair.measure = measure, pair.axis = axis, pair.a = a, pair.b = b, pair.at = at, pair.sameRuns = true;
  const auto conditions = partners(results, axis, a, b, at);
  std::set<std::vector<std::size_t>> seen;  // the tasks of pairs so far
  bool varies = false;                      // true if one of the conditions uses the seed
  bool onePath = true;                      // true if none of them gives runs that differ
  for (std::size_t s = 0; s < results.seeds.size(); ++s) {
    double sumA = 0, sumB = 0;
    std::vector<std::size_t> tasks;
    for (const auto& [i, j] : conditions) {
      const std::size_t ti = results.conditions[i].tasks[s], tj = results.conditions[j].tasks[s];
      const auto of = results.end(measure, ti), against = results.end(measure, tj);
      if (!of || !against) continue;
      sumA += *of, sumB += *against;
      tasks.push_back(ti), tasks.push_back(tj);
      pair.sameRuns = pair.sameRuns && ti == tj;
      varies = varies || results.conditions[i].usesSeed || results.conditions[j].usesSeed;
      onePath = onePath && onePaths.contains(i) && onePaths.contains(j);
    }
    if (tasks.empty()) continue;
    ++pair.seeds;
    if (!seen.insert(tasks).second) continue;
    const double count = static_cast<double>(tasks.size() / 2);
    pair.of.push_back(sumA / count), pair.against.push_back(sumB / count);
  }
  if (pair.of.empty()) return pair;
  pair.meanA = mean(pair.of), pair.meanB = mean(pair.against);
  pair.signs = signsOf(pair.of, pair.against);
  if (isOnePath(pair, onePath && pair.of.size() > 1)) {
    pair.known = Known::onePath;
    pair.paired.difference = pair.meanA - pair.meanB;
    return pair;
  }
  if (pair.of.size() > 1) {
    pair.paired = comparePaired(pair.of, pair.against);
    pair.unpaired = compareUnpaired(pair.of, pair.against);
    pair.effect = effectSizes(pair.of, pair.against);
    return pair;
  }
  pair.known = varies && !pair.sameRuns ? Known::oneSeed : Known::exact;
  pair.paired.difference = pair.of.front() - pair.against.front();
  return pair;
}

/// Returns all ways to fix the other compared axes. The first, and without `within` the only one, fixes none.
std::vector<Fixed> fixedLevels(const StudyComparison& c, std::size_t axis, bool within) {
  std::vector<Fixed> all{Fixed(c.results.axes.size())};
  if (!within) return all;
  std::vector<Fixed> open = all;
  for (const std::size_t other : comparedAxes(c)) {
    if (other == axis) continue;
    std::vector<Fixed> next;
    for (const Fixed& f : open)
      for (std::size_t level = 0; level < c.results.axes[other].labels.size(); ++level)
        next.push_back(f), next.back()[other] = level;
    open = std::move(next);
  }
  if (open.size() > 1) all.insert(all.end(), open.begin(), open.end());
  return all;
}

/// Returns the measures with one value in all runs. They cannot differ, and would only make the family of tests larger.
std::set<std::size_t> constantMeasures(const StudyComparison& c) {
  std::set<std::size_t> constant(c.measures.begin(), c.measures.end());
  std::map<std::size_t, double> first;
  for (const ConditionSummary& s : c.conditions)
    for (const double v : s.values)
      if (first.emplace(s.measure, v).first->second != v) constant.erase(s.measure);
  return constant;
}

/// Corrects p-values by Holm over all pairs that have one: only these could differ by chance.
template <class Get, class Set>
void correct(std::vector<PairComparison>& pairs, const Get& get, const Set& set) {
  std::vector<double> p;
  std::vector<PairComparison*> of;
  for (PairComparison& pair : pairs)
    if (const auto value = get(pair)) p.push_back(*value), of.push_back(&pair);
  const auto corrected = correctHolm(p);
  for (std::size_t i = 0; i < of.size(); ++i) set(*of[i], corrected[i]);
}

void testEquivalences(StudyComparison& c) {
  for (PairComparison& pair : c.pairs) {
    const auto margin = marginOf(c.margins, c.measureName(pair.measure), 0.5 * (pair.meanA + pair.meanB));
    if (!margin || pair.known == Known::oneSeed) continue;
    auto& same = pair.equivalence.emplace();
    if (isTooWide(rangeOf(c, pair.measure), *margin)) {
      same = {.test = {.margin = *margin}, .verdict = Equivalent::untested};
      continue;
    }
    same.test = testEquivalence(pair.paired, *margin);
    same.corrected = same.test.p, same.correctedBeyond = same.test.pBeyond;
  }
  using Value = std::optional<double>;
  const auto tested = [](const PairComparison& p) {
    return p.equivalence && p.equivalence->verdict != Equivalent::untested && p.known == Known::estimated;
  };
  correct(
      c.pairs, [&](PairComparison& p) { return tested(p) ? Value(p.equivalence->test.p) : Value(); },
      [](PairComparison& p, double corrected) { p.equivalence->corrected = corrected; });
  correct(
      c.pairs, [&](PairComparison& p) { return tested(p) ? Value(p.equivalence->test.pBeyond) : Value(); },
      [](PairComparison& p, double corrected) { p.equivalence->correctedBeyond = corrected; });
  for (PairComparison& p : c.pairs)
    if (p.equivalence && p.equivalence->verdict != Equivalent::untested)
      p.equivalence->verdict = verdictOf(p.equivalence->corrected, p.equivalence->correctedBeyond);
}

/// Adds a comparison of every two levels of an axis, with the other axes fixed as in `at`.
void addPairs(const StudyComparison& c, std::size_t measure, std::size_t axis, const Fixed& at,
              std::vector<PairComparison>& pairs) {
  const std::size_t levels = c.results.axes[axis].labels.size();
  for (std::size_t a = 0; a < levels; ++a)
    for (std::size_t b = a + 1; b < levels; ++b) {
      auto pair = compare(c, measure, axis, a, b, at);
      if (pair.seeds > 0) pairs.push_back(std::move(pair));
    }
}

void correctDifferences(const StudyComparison& c, std::vector<PairComparison>& pairs) {
  const auto constant = constantMeasures(c);
  correct(
      pairs,
      [&](PairComparison& p) {
        const bool tested = p.known == Known::estimated && !p.sameRuns && !constant.contains(p.measure);
        return tested ? std::optional(p.paired.p) : std::nullopt;
      },
      [](PairComparison& p, double corrected) { p.corrected = corrected; });
}

}  // namespace

bool PairComparison::isOfMean() const {
  return std::ranges::none_of(at, [](const auto& level) { return level.has_value(); });
}

std::optional<double> PairComparison::intervalRatio() const {
  // Differences without variance cannot show what pairing saves.
  if (!unpaired || !unpaired->interval || !paired.interval) return std::nullopt;
  return studentInterval(paired.estimate(), 0.95).width() / unpaired->interval->width();
}

void comparePairs(StudyComparison& c, bool within) {
  for (const std::size_t m : c.measures)
    for (const std::size_t axis : comparedAxes(c))
      for (const Fixed& at : fixedLevels(c, axis, within)) addPairs(c, m, axis, at, c.pairs);
  correctDifferences(c, c.pairs);
  testEquivalences(c);
}

void splitPairs(StudyComparison& c) {
  for (const std::size_t m : c.measures)
    for (const std::size_t axis : comparedAxes(c)) {
      const auto interaction = interactionOf(c, m, axis);
      for (std::size_t l = 0; interaction && l < c.results.axes[interaction->other].labels.size(); ++l) {
        Fixed at(c.results.axes.size());
        at[interaction->other] = l;
        addPairs(c, m, axis, at, c.split);
      }
    }
  correctDifferences(c, c.split);
}

}  // namespace morula
