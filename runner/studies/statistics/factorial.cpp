#include "statistics/factorial.h"

#include <algorithm>

#include "base/error.h"
#include "statistics/bootstrap.h"
#include "statistics/distributions.h"

namespace morula {

namespace {

struct Design {
  std::vector<std::size_t> levels;
  std::size_t cells = 1, replicates = 0;

  Design(std::span<const std::size_t> l, std::size_t values) : levels(l.begin(), l.end()) {
    for (const std::size_t n : levels) {
      MORULA_CHECK(n > 1, "a factor has two levels at least");
      cells *= n;
    }
    replicates = values / cells;
    MORULA_CHECK(values > 0 && replicates * cells == values, "as many values in each cell");
  }

  std::size_t level(std::size_t value, std::size_t factor) const {
    std::size_t cell = value / replicates;
    for (std::size_t f = levels.size() - 1; f > factor; --f) cell /= levels[f];
    return cell % levels[factor];
  }
};

/// Means over all values that have the same levels of these factors, the last one changing fastest.
std::vector<double> meansBy(const Design& design, std::span<const double> values,
                            std::span<const std::size_t> factors) {
  std::size_t count = 1;
  for (const std::size_t f : factors) count *= design.levels[f];
  std::vector<double> means(count);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::size_t group = 0;
    for (const std::size_t f : factors) group = group * design.levels[f] + design.level(i, f);
    means[group] += values[i];
  }
  const double each = static_cast<double>(values.size() / count);
  for (double& m : means) m /= each;
  return means;
}

/// Σ over all values of the square of the effect of their level.
double squaresOf(const Design& design, std::span<const double> values, const FactorEffect& effect,
                 double whole) {
  const auto means = meansBy(design, values, effect.factors);
  const double each = static_cast<double>(values.size()) / static_cast<double>(means.size());
  double sum = 0;
  if (effect.factors.size() == 1) {
    for (const double m : means) sum += (m - whole) * (m - whole);
    return each * sum;
  }
  const std::size_t a = effect.factors[0], b = effect.factors[1];
  const auto byA = meansBy(design, values, std::span(&a, 1)), byB = meansBy(design, values, std::span(&b, 1));
  for (std::size_t i = 0; i < byA.size(); ++i)
    for (std::size_t j = 0; j < byB.size(); ++j) {
      const double e = means[i * byB.size() + j] - byA[i] - byB[j] + whole;
      sum += e * e;
    }
  return each * sum;
}

/// What is left of each value without the mean of its cell and, with blocks, what its replicate has in common.
double errorSquares(const Design& design, std::span<const double> values, double whole, bool blocks) {
  const std::size_t n = design.replicates;
  std::vector<double> block(n, whole);
  if (blocks) {
    std::fill(block.begin(), block.end(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) block[i % n] += values[i];
    for (double& b : block) b /= static_cast<double>(design.cells);
  }
  double sum = 0;
  for (std::size_t c = 0; c < design.cells; ++c) {
    const double cell = mean(values.subspan(c * n, n));
    for (std::size_t r = 0; r < n; ++r) {
      const double rest = values[c * n + r] - cell - (block[r] - whole);
      sum += rest * rest;
    }
  }
  return sum;
}

}  // namespace

FactorialAnalysis analyseFactorial(std::span<const std::size_t> levels, std::span<const double> values,
                                   bool blocks) {
  const Design design(levels, values.size());
  const double whole = mean(values), n = static_cast<double>(design.replicates);
  const double cells = static_cast<double>(design.cells);
  FactorialAnalysis analysis;
  double size = 0;
  for (const double x : values) analysis.squares += (x - whole) * (x - whole), size += x * x;
  analysis.errorDegreesOfFreedom = blocks ? (cells - 1) * (n - 1) : cells * (n - 1);
  analysis.errorSquares = errorSquares(design, values, whole, blocks);
  // What rounding leaves of values that do not vary is no error to test against.
  const bool varies = analysis.errorDegreesOfFreedom > 0 && analysis.errorSquares > 1e-24 * size;
  for (std::size_t a = 0; a < design.levels.size(); ++a) analysis.effects.push_back({.factors = {a}});
  for (std::size_t a = 0; a < design.levels.size(); ++a)
    for (std::size_t b = a + 1; b < design.levels.size(); ++b)
      analysis.effects.push_back({.factors = {a, b}});
  for (FactorEffect& e : analysis.effects) {
    e.degreesOfFreedom = 1;
    for (const std::size_t f : e.factors) e.degreesOfFreedom *= static_cast<double>(design.levels[f] - 1);
    e.squares = squaresOf(design, values, e, whole);
    e.share = analysis.squares > 0 ? e.squares / analysis.squares : 0;
    if (!varies) continue;
    const double error = analysis.errorSquares / analysis.errorDegreesOfFreedom;
    e.partial = e.squares / (e.squares + analysis.errorSquares);
    e.f = e.squares / e.degreesOfFreedom / error;
    e.p = fisherAbove(*e.f, e.degreesOfFreedom, analysis.errorDegreesOfFreedom);
  }
  return analysis;
}

std::vector<double> levelMeans(std::span<const std::size_t> levels, std::span<const double> values,
                               std::size_t factor) {
  return meansBy(Design(levels, values.size()), values, std::span(&factor, 1));
}

}  // namespace morula
