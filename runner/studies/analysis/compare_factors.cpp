// Main effects and interactions.
#include "analysis/compare_parts.h"
#include "statistics/equivalence.h"

namespace morula {
namespace {

/// A cell of the design: all conditions with these levels of the axes that are compared.
using DesignCell = std::vector<std::size_t>;

std::vector<DesignCell> cellsOf(const StudyResults& results, const std::vector<std::size_t>& axes) {
  std::size_t count = 1;
  for (const std::size_t a : axes) count *= results.axes[a].labels.size();
  std::vector<DesignCell> cells(count);
  for (std::size_t i = 0; i < results.conditions.size(); ++i) {
    std::size_t cell = 0;
    for (const std::size_t a : axes) cell = cell * results.axes[a].labels.size() + results.conditions[i].levels[a];
    cells[cell].push_back(i);
  }
  return cells;
}

/// Returns the mean over the cell's conditions under one seed. Absent if a condition has no value.
std::optional<double> valueOf(const StudyResults& results, std::size_t measure, const DesignCell& cell,
                              std::size_t seed) {
  double sum = 0;
  for (const std::size_t i : cell) {
    const auto value = results.end(measure, results.conditions[i].tasks[seed]);
    if (!value) return std::nullopt;
    sum += *value;
  }
  if (cell.empty()) return std::nullopt;
  return sum / static_cast<double>(cell.size());
}

std::optional<MeasureEffects> effectsOf(const StudyComparison& c, std::size_t measure,
                                        const std::vector<std::size_t>& axes) {
  const StudyResults& r = c.results;
  const auto cells = cellsOf(r, axes);
  std::vector<std::vector<double>> bySeed;  // [seed][cell] of complete seeds
  for (std::size_t s = 0; s < r.seeds.size(); ++s) {
    std::vector<double> values;
    for (const DesignCell& cell : cells)
      if (const auto v = valueOf(r, measure, cell, s)) values.push_back(*v);
    if (values.size() == cells.size()) bySeed.push_back(std::move(values));
  }
  if (bySeed.empty()) return std::nullopt;
  std::vector<double> values;
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    for (const auto& seed : bySeed) values.push_back(seed[cell]);
  std::vector<std::size_t> levels;
  for (const std::size_t a : axes) levels.push_back(r.axes[a].labels.size());
  MeasureEffects effects{.measure = measure, .axes = axes, .seeds = bySeed.size()};
  effects.analysis = analyseFactorial(levels, values);
  for (std::size_t f = 0; f < axes.size(); ++f) effects.means.push_back(levelMeans(levels, values, f));
  if (bySeed.size() < 2)
    effects.untested =
        "only one seed has values in all conditions, so their variation is not "
        "known";
  return effects;
}

}  // namespace

std::optional<Interaction> interactionOf(const StudyComparison& c, std::size_t measure, std::size_t axis) {
  std::optional<Interaction> strongest;
  double most = 0;
  for (const MeasureEffects& effects : c.effects)
    for (std::size_t i = 0; i < effects.analysis.effects.size(); ++i) {
      const FactorEffect& e = effects.analysis.effects[i];
      if (effects.measure != measure || e.factors.size() < 2 || effects.corrected[i].value_or(1) >= 0.05) continue;
      const std::size_t one = effects.axes[e.factors[0]], two = effects.axes[e.factors[1]];
      if ((one != axis && two != axis) || !(e.share > most)) continue;
      most = e.share;
      strongest = Interaction{&effects, i, one == axis ? two : one};
    }
  return strongest;
}

void compareFactors(StudyComparison& c) {
  const auto axes = comparedAxes(c);
  if (axes.empty()) return;
  for (const std::size_t m : c.measures)
    if (auto effects = effectsOf(c, m, axes)) c.effects.push_back(std::move(*effects));
  std::vector<double> p;
  for (const MeasureEffects& effects : c.effects)
    for (const FactorEffect& e : effects.analysis.effects)
      if (e.p) p.push_back(*e.p);
  const auto corrected = correctHolm(p);
  std::size_t next = 0;
  for (MeasureEffects& effects : c.effects)
    for (const FactorEffect& e : effects.analysis.effects)
      effects.corrected.push_back(e.p ? std::optional(corrected[next++]) : std::nullopt);
}

}  // namespace morula
