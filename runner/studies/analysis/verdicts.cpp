// The sentences of a comparison, with the numbers of its tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/compare_parts.h"
#include "analysis/measure_words.h"
#include "base/number_text.h"
#include "files/text.h"
#include "observation/asked_measure.h"

namespace morula {
namespace {

/// A measure whose values differ by less than this fraction of the largest one, without a difference that is shown, is
/// reported as telling nothing.
constexpr double littleRange = 0.01;

/// Returns the range of a measure's values as a share of their largest distance from the measure's zero.
double shareOfRange(const StudyComparison& c, std::size_t measure) {
  const ValueRange range = rangeOf(c, measure);
  const double zero = wordsOfMeasure(c.measureName(measure)).zero;
  const double size = std::max(std::abs(range.low - zero), std::abs(range.high - zero));
  return size > 0 ? (range.high - range.low) / size : 0;
}

/// Returns "p = 0.012"; "p < 1e-15" for values whose digits are rounding errors; "" without a p-value.
std::string pText(const std::optional<double>& p) {
  if (!p) return "";
  const bool isClose = *p > 0.045 && *p < 0.055;  // close to 0.05, two digits might not show the side
  return *p < 1e-15 ? "p < 1e-15" : "p = " + numberText(*p, isClose ? 3 : 2);
}

bool anyShown(const StudyComparison& c, std::size_t measure) {
  return std::ranges::any_of(c.pairs, [&](const PairComparison& p) { return p.measure == measure && isDifferent(p); });
}

bool anyEffect(const StudyComparison& c, std::size_t measure) {
  return std::ranges::any_of(c.effects, [&](const MeasureEffects& e) {
    return e.measure == measure && std::ranges::any_of(e.corrected, [](const auto& p) { return p.value_or(1) < 0.05; });
  });
}

/// Returns true if all values lie close together and no difference or effect is shown.
bool tellsNothing(const StudyComparison& c, std::size_t measure) {
  return shareOfRange(c, measure) <= littleRange && !anyShown(c, measure) && !anyEffect(c, measure);
}

/// Sentences in the order of measures and pairs: `known`, with a shown difference or a test of equivalence, are printed
/// first.
struct Verdicts {
  std::vector<std::string> known, open;
};

std::string place(const StudyComparison& c, const PairComparison& pair) { return withLevels(c.results, pair.at); }

const std::string& label(const StudyComparison& c, const PairComparison& pair, std::size_t level) {
  return c.results.axes[pair.axis].labels[level];
}

/// Returns "clone_radius: 4.5 % tighter under longest (0.742) than under random (0.777)"; percentages of a measure that
/// varies from another value than 0 name their scale, as "sphericity: rounder by 12 % of 1 − sphericity under …".
std::string differs(const StudyComparison& c, const PairComparison& pair) {
  const MeasureWords words = wordsOfMeasure(c.measureName(pair.measure));
  const double d = pair.paired.difference;
  const double a = pair.meanA - words.zero, b = pair.meanB - words.zero;
  const bool relative = (words.zero == 0 ? a > 0 && b > 0 : a * b > 0) && std::abs(d) < std::abs(b);
  const std::string size = relative ? numberText(100 * std::abs(d / b), 2) + " %" : numberText(std::abs(d), 2);
  const std::string& more = d > 0 ? words.more : words.less;
  return fmt::format("{}: {} under {} ({}) than under {} ({}){}", c.measureName(pair.measure),
                     relative && words.zero != 0 ? more + " by " + size + " of " + words.scale : size + " " + more,
                     label(c, pair, pair.a), numberText(pair.meanA, 3), label(c, pair, pair.b),
                     numberText(pair.meanB, 3), place(c, pair));
}

/// Returns "every one of 10 pairs" or "9 of 10 pairs".
std::string inHowMany(const PairComparison& pair) {
  const std::size_t n = pair.signs.pairs(), with = pair.paired.difference > 0 ? pair.signs.higher : pair.signs.lower;
  return with == n ? fmt::format("every one of {} pairs", n) : fmt::format("{} of {} pairs", with, n);
}

/// Returns ", 95 % interval −0.1 to 0.2", or ", in every pair" without an interval. A shape of the sample that is not
/// plain follows in brackets.
std::string intervalText(const char* level, const std::optional<Interval>& interval,
                         SampleShape shape = SampleShape::plain) {
  if (!interval) return ", in every pair";
  return fmt::format(", {} interval {} to {}{}", level, numberText(interval->low, 2), numberText(interval->high, 2),
                     shape == SampleShape::plain ? "" : std::string(" (") + nameOf(shape) + ")");
}

/// Returns "difference 0.05, 95 % interval 0.04 to 0.06, p = 0.0012 after Holm".
std::string estimate(const PairComparison& pair) {
  return fmt::format("difference {}{}{}", numberText(pair.paired.difference, 2),
                     intervalText("95 %", pair.paired.interval, pair.paired.sample.shape),
                     pair.corrected ? ", " + pText(pair.corrected) + " after Holm" : "");
}

std::string pairVerdict(const StudyComparison& c, const PairComparison& pair) {
  const std::string& name = c.measureName(pair.measure);
  const std::string between =
      fmt::format("{} and {}{}", label(c, pair, pair.a), label(c, pair, pair.b), place(c, pair));
  if (pair.sameRuns) return fmt::format("{}: the runs of {} are the same", name, between);
  switch (pair.known) {
    case Known::exact:
      return pair.paired.difference == 0
                 ? fmt::format("{}: equal under {}, and no seed changes the value", name, between)
                 : differs(c, pair) + ", exactly, because seeds change neither side";
    case Known::onePath:
      return isDifferent(pair) ? fmt::format("{}, on one path each: the {} runs of each are one run but for rounding",
                                             differs(c, pair), pair.of.size())
                               : fmt::format("{}: equal but for rounding under {}", name, between);
    case Known::oneSeed: return differs(c, pair) + ", in one pair of runs, so the variation is not known";
    case Known::estimated: break;
  }
  if (pair.isShown()) return fmt::format("{}, {}: {}", differs(c, pair), inHowMany(pair), estimate(pair));
  return fmt::format("{}: no difference is shown between {} ({}) and {} ({}){}: {}, n = {}", name,
                     label(c, pair, pair.a), numberText(pair.meanA, 3), label(c, pair, pair.b),
                     numberText(pair.meanB, 3), place(c, pair), estimate(pair), pair.of.size());
}

/// Returns the end of a sentence: "; equivalent within ±0.1, 90 % interval 0.04 to 0.06, p = 0.01 after Holm".
std::string equivalenceText(const PairComparison& pair) {
  if (!pair.equivalence) return "";
  const auto& same = *pair.equivalence;
  if (same.verdict == Equivalent::untested)
    return fmt::format("; equivalence is not tested, because ±{} is wider than the range of all values",
                       numberText(same.test.margin, 3));
  const double p = same.verdict == Equivalent::no ? same.correctedBeyond : same.corrected;
  const bool isSmall = same.verdict == Equivalent::yes && isDifferent(pair);
  return fmt::format("; {}{} within ±{}{}{}", isSmall ? "a small difference, " : "", nameOf(same.verdict),
                     numberText(same.test.margin, 3),
                     intervalText("90 %", same.test.interval, pair.paired.sample.shape),
                     pair.known == Known::estimated ? ", " + pText(p) + " after Holm" : "");
}

void addMeasure(const StudyComparison& c, std::size_t measure, Verdicts& verdicts) {
  const ValueRange spread = rangeOf(c, measure);
  if (!(spread.low <= spread.high)) {
    verdicts.open.push_back(c.measureName(measure) + ": no run has a value");
    return;
  }
  const bool isSilent = tellsNothing(c, measure);
  if (isSilent) {
    const std::string low = numberText(spread.low, 3), high = numberText(spread.high, 3);
    verdicts.known.push_back(fmt::format("{} is {} everywhere, so it distinguishes no conditions",
                                         c.measureName(measure), low == high ? low : low + " to " + high));
  }
  for (const PairComparison& pair : c.pairs) {
    if (pair.measure != measure) continue;
    // If the effect depends on another axis, axisVerdicts states it at each level of that axis; the mean is left out.
    if (!pair.equivalence && (isSilent || (pair.isOfMean() && interactionOf(c, measure, pair.axis)))) continue;
    auto& part = isDifferent(pair) || pair.equivalence ? verdicts.known : verdicts.open;
    part.push_back(pairInWords(c, pair));
  }
}

/// Returns "η² 0.62, partial η² 0.9, 95 % interval 0.7 to 0.95, p = 0.001 after Holm".
std::string effectText(const MeasureEffects& effects, std::size_t effect) {
  const FactorEffect& e = effects.analysis.effects[effect];
  return fmt::format("η² {}{}, {} after Holm", shareText(e.share),
                     e.partialInterval ? fmt::format(", partial η² {}{}", numberText(*e.partial, 2),
                                                     intervalText("95 %", e.partialInterval))
                                       : "",
                     pText(effects.corrected[effect]));
}

/// Returns "a: its effect on volume depends on b (interaction, η² …)"; interactionTables gives it at each level of b.
std::string interactionVerdict(const StudyComparison& c, std::size_t axis, const Interaction& interaction) {
  return fmt::format("{}: its effect on {} depends on {} (interaction, {})", c.results.axes[axis].name,
                     c.measureName(interaction.of->measure), c.results.axes[interaction.other].name,
                     effectText(*interaction.of, interaction.effect));
}

/// Returns "division: decides on clone_radius (η² 0.62, 95 % interval …): longest 0.742, random 0.794".
std::string effectVerdict(const StudyComparison& c, const MeasureEffects& effects, std::size_t axis) {
  const ResultAxis& of = c.results.axes[effects.axes[axis]];
  std::vector<std::string> means;
  std::vector<const PairComparison*> pairs;
  for (const PairComparison& p : c.pairs)
    if (p.measure == effects.measure && p.axis == effects.axes[axis] && p.isOfMean()) pairs.push_back(&p);
  const std::string which = levelsThatDiffer(c, pairs);
  // Pairs have the means of the seeds that they compare, the analysis those of the seeds with a value everywhere.
  std::map<std::size_t, double> compared;
  for (const PairComparison* p : pairs) compared[p->a] = p->meanA, compared[p->b] = p->meanB;
  for (std::size_t l = 0; l < of.labels.size(); ++l)
    means.push_back(of.labels[l] + " " +
                    numberText(which.empty() || !compared.contains(l) ? effects.means[axis][l] : compared[l], 3));
  const std::string ending = pairs.size() < 2 ? ""
                             : which.empty()  ? ": no two of them are shown to differ"
                                              : ": " + which + " differ";
  return fmt::format("{}: decides on {} ({}): {}", of.name, c.measureName(effects.measure), effectText(effects, axis),
                     join(means) + ending);
}

/// Returns, for each axis, a line for each measure that it affects, and a line for all other measures. A single axis
/// with two levels has none, because its pair of levels gives the same sentence.
std::vector<std::string> axisVerdicts(const StudyComparison& c) {
  std::vector<std::string> lines;
  const auto axes = comparedAxes(c);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const ResultAxis& axis = c.results.axes[axes[a]];
    if (axes.size() == 1 && axis.labels.size() < 3) continue;
    std::vector<std::string> others;
    double least = 1;
    for (const MeasureEffects& effects : c.effects) {
      const auto& p = effects.corrected[a];
      if (tellsNothing(c, effects.measure)) continue;
      if (const auto interaction = interactionOf(c, effects.measure, axes[a])) {
        lines.push_back(interactionVerdict(c, axes[a], *interaction));
      } else if (p && *p < 0.05) {
        lines.push_back(effectVerdict(c, effects, a));
      } else if (p) {
        const auto& interval = effects.analysis.effects[a].partialInterval;
        others.push_back(c.measureName(effects.measure) + " (η² " + shareText(effects.analysis.effects[a].share) +
                         (interval ? ", partial η² at most " + numberText(interval->high, 2) : "") + ")");
        least = std::min(least, *p);
      }
    }
    if (!others.empty())
      lines.push_back(fmt::format("{}: no effect is shown on {}; p {} {} after Holm", axis.name, join(others),
                                  others.size() > 1 ? "at least" : "=", numberText(least, 2)));
  }
  return lines;
}

/// Names the measures that follow the number of cells, if conditions end with different numbers of cells.
void addNumbersOfCells(const StudyComparison& c, std::vector<std::string>& verdicts) {
  std::vector<std::string> following;
  for (const std::size_t m : c.measures)
    if (const auto known = findMeasure(c.measureName(m)); known && known->followsNumber && !tellsNothing(c, m))
      following.push_back(known->name);
  ValueRange numbers;
  for (const ResultCondition& condition : c.results.conditions) {
    std::vector<double> cells;
    for (const std::size_t t : condition.tasks)
      if (t != noTask && c.results.tasks[t].cells > 0) cells.push_back(double(c.results.tasks[t].cells));
    if (cells.empty()) continue;
    const double average = mean(cells);
    numbers.low = std::min(numbers.low, average), numbers.high = std::max(numbers.high, average);
  }
  if (following.empty() || !(numbers.low < numbers.high)) return;
  verdicts.push_back(
      fmt::format("numbers of cells differ between conditions, {} to {} in the mean; {} {} with the number of "
                  "cells, even if cells are arranged alike",
                  numberText(numbers.low, 4), numberText(numbers.high, 4), join(following),
                  following.size() > 1 ? "change" : "changes"));
}

/// Adds how much narrower intervals are because both runs of a pair have the same seed.
void addCommonRandomNumbers(const StudyComparison& c, std::vector<std::string>& verdicts) {
  const PairComparison* best = nullptr;
  double least = INFINITY, most = 0;
  for (const PairComparison& pair : c.pairs) {
    const auto ratio = pair.intervalRatio();
    if (!ratio) continue;
    if (*ratio < least) least = *ratio, best = &pair;
    most = std::max(most, *ratio);
  }
  if (!best) return;
  const std::string where = fmt::format("{}: {} and {}{}", c.measureName(best->measure), label(c, *best, best->a),
                                        label(c, *best, best->b), place(c, *best));
  verdicts.push_back(
      fmt::format("common random numbers: the interval of a paired difference is {} of the unpaired one at "
                  "best ({}), {} at most",
                  numberText(least, 2), where, numberText(most, 2)));
}

}  // namespace

std::string shareText(double share) { return share < 0.001 ? "below 0.001" : numberText(share, 2); }

bool isDifferent(const PairComparison& p) {
  const double size = std::max(std::abs(p.meanA), std::abs(p.meanB));
  return p.isShown() || (p.known == Known::exact && p.paired.difference != 0) ||
         (p.known == Known::onePath && std::abs(p.paired.difference) > onePathSpread * size);
}

std::string withLevels(const StudyResults& results, const std::vector<std::optional<std::size_t>>& at) {
  std::vector<std::string> fixed;
  for (std::size_t a = 0; a < at.size(); ++a)
    if (at[a]) fixed.push_back(results.axes[a].name + ": " + results.axes[a].labels[*at[a]]);
  return fixed.empty() ? "" : " with " + join(fixed);
}

std::string pairInWords(const StudyComparison& c, const PairComparison& pair) {
  return pairVerdict(c, pair) + equivalenceText(pair);
}

std::vector<std::string> verdictsOf(const StudyComparison& c) {
  Verdicts verdicts;
  for (const std::size_t m : c.measures) addMeasure(c, m, verdicts);
  std::vector<std::string> all = axisVerdicts(c);
  all.insert(all.end(), verdicts.known.begin(), verdicts.known.end());
  all.insert(all.end(), verdicts.open.begin(), verdicts.open.end());
  addNumbersOfCells(c, all);
  addCommonRandomNumbers(c, all);
  addIntervals(c, all);
  return all;
}

std::vector<std::string> troublesOf(const StudyResults& r) {
  std::vector<std::string> lines;
  for (const auto& [condition, seed, task] : troubledRuns(r)) {
    const std::string which = fmt::format("{}, seed {}", condition, seed);
    if (task.status == TaskStatus::done)
      lines.push_back("not sane  " + which + ": " + task.reason + "; the values of this run are included");
    else lines.push_back(nameOf(task.status) + ("  " + which) + (task.reason.empty() ? "" : ": " + task.reason));
  }
  std::size_t combinations = 1;
  for (const ResultAxis& axis : r.axes) combinations *= axis.labels.size();
  if (r.conditions.size() < combinations)
    lines.push_back(fmt::format("left out  {} of {} combinations: effects of axes and interactions are not known",
                                combinations - r.conditions.size(), combinations));
  for (const auto& names : namesOfSameRuns(r)) lines.push_back("equal runs  " + join(names, " = "));
  return lines;
}

}  // namespace morula
