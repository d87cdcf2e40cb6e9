#include "statistics/factorial.h"

#include <algorithm>

#include "base/error.h"
#include "statistics/distributions.h"
#include "statistics/means.h"
#include "statistics/sign_flip.h"

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

  std::size_t level(std::size_t cell, std::size_t factor) const {
    for (std::size_t f = levels.size() - 1; f > factor; --f) cell /= levels[f];
    return cell % levels[factor];
  }
};

/// An effect in each replicate: [replicate][group], with a group for each combination of its factors' levels, the last
/// factor changing fastest. Values add up to 0 over the levels of each factor.
struct Contrasts {
  std::size_t groups = 1;
  std::vector<double> values;

  Contrasts(const Design& design, std::span<const double> all, std::span<const std::size_t> factors) {
    for (const std::size_t f : factors) groups *= design.levels[f];
    values.assign(design.replicates * groups, 0.0);
    for (std::size_t cell = 0; cell < design.cells; ++cell) {
      std::size_t group = 0;
      for (const std::size_t f : factors) group = group * design.levels[f] + design.level(cell, f);
      for (std::size_t r = 0; r < design.replicates; ++r)
        values[r * groups + group] += all[cell * design.replicates + r];
    }
    for (double& v : values) v /= static_cast<double>(design.cells / groups);
    const std::size_t rows = design.levels[factors[0]], columns = groups / rows;
    for (std::size_t r = 0; r < design.replicates; ++r) {
      centre(r * groups, columns, 1, rows, columns);
      if (columns > 1) centre(r * groups, rows, columns, columns, 1);
    }
  }

  std::vector<double> means() const {
    std::vector<double> sums(groups);
    for (std::size_t i = 0; i < values.size(); ++i) sums[i % groups] += values[i];
    for (double& s : sums) s /= static_cast<double>(values.size() / groups);
    return sums;
  }

 private:
  /// Subtracts the mean of each of `sets` sets of `count` numbers, `stride` apart; sets begin `next` apart.
  void centre(std::size_t first, std::size_t sets, std::size_t next, std::size_t count, std::size_t stride) {
    for (std::size_t set = first; set < first + sets * next; set += next) {
      double sum = 0;
      for (std::size_t i = 0; i < count; ++i) sum += values[set + i * stride];
      for (std::size_t i = 0; i < count; ++i) values[set + i * stride] -= sum / static_cast<double>(count);
    }
  }
};

/// Returns ε of deviations [replicate][group] from the effect's means.
double epsilonOf(std::span<const double> deviations, std::size_t groups, double d) {
  const std::size_t n = deviations.size() / groups;
  double trace = 0, squares = 0;  // traces of the covariance matrix and its square, times n − 1
  for (std::size_t g = 0; g < groups; ++g)
    for (std::size_t h = 0; h < groups; ++h) {
      double sum = 0;
      for (std::size_t r = 0; r < n; ++r) sum += deviations[r * groups + g] * deviations[r * groups + h];
      squares += sum * sum;
      if (g == h) trace += sum;
    }
  const double nu = static_cast<double>(n - 1);
  const double low = std::clamp(trace * trace / (d * squares), 1 / d, 1.0);
  if (n == 2) return low;  // one deviation tells nothing of others
  const double of = (nu + 1) * d * low - 2, over = d * (nu - d * low);
  const double high = over > 0 ? std::clamp(of / over, 1 / d, 1.0) : 1.0;
  return 0.25 * low + 0.75 * high;
}

/// Returns the noncentrality with which F exceeds `f` in this share of studies; 0 if F does so more often without any.
double noncentralityOf(double share, double f, double df1, double df2) {
  const NoncentralFisher fisher(f, df1, df2);
  double low = 0, high = 1;
  if (fisher.above(0) >= share) return 0;
  while (fisher.above(high) < share) low = high, high *= 2;
  for (int turn = 0; turn < 40; ++turn) {
    const double middle = 0.5 * (low + high);
    (fisher.above(middle) < share ? low : high) = middle;
  }
  return high;
}

/// Bounds partial η². An F below 1 is chance, and bounds the effect no better than F = 1.
Interval partialIntervalOf(const FactorEffect& e, double n) {
  const double df = e.epsilon * e.degreesOfFreedom, dfError = e.epsilon * e.errorDegreesOfFreedom;
  const auto at = [&](double share, double f) {
    const double lambda = noncentralityOf(share, f, df, dfError);
    return lambda / (lambda + df * n);
  };
  return {at(0.025, *e.f), at(0.975, std::max(*e.f, 1.0))};
}

void test(FactorEffect& e, const Design& design, const Contrasts& contrasts, double whole, double size) {
  const double n = static_cast<double>(design.replicates);
  const double each = static_cast<double>(design.cells / contrasts.groups);
  const std::vector<double> means = contrasts.means();
  double effect = 0, error = 0;
  for (const double m : means) effect += m * m;
  std::vector<double> deviations = contrasts.values;
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    deviations[i] -= means[i % contrasts.groups];
    error += deviations[i] * deviations[i];
  }
  e.squares = each * n * effect;
  e.errorSquares = each * error;
  e.share = whole > 0 ? e.squares / whole : 0;
  e.errorDegreesOfFreedom = e.degreesOfFreedom * (n - 1);
  // Values that vary by less than a millionth are one path, with no error to test against.
  if (!(n > 1) || !(e.errorSquares > 1e-12 * size)) return;
  e.partial = e.squares / (e.squares + e.errorSquares);
  e.f = e.squares / (e.errorSquares / (n - 1));
  e.epsilon = epsilonOf(deviations, contrasts.groups, e.degreesOfFreedom);
  e.p = fisherAbove(*e.f, e.epsilon * e.degreesOfFreedom, e.epsilon * e.errorDegreesOfFreedom);
  e.partialInterval = partialIntervalOf(e, n);
  if (repeats(contrasts.values, contrasts.groups)) e.p = std::max(*e.p, signFlipP(contrasts.values, contrasts.groups));
}

}  // namespace

FactorialAnalysis analyseFactorial(std::span<const std::size_t> levels, std::span<const double> values) {
  const Design design(levels, values.size());
  const double whole = mean(values);
  FactorialAnalysis analysis;
  double size = 0;
  for (const double x : values) analysis.squares += (x - whole) * (x - whole), size += x * x;
  for (std::size_t a = 0; a < design.levels.size(); ++a) analysis.effects.push_back({.factors = {a}});
  for (std::size_t a = 0; a < design.levels.size(); ++a)
    for (std::size_t b = a + 1; b < design.levels.size(); ++b) analysis.effects.push_back({.factors = {a, b}});
  for (FactorEffect& e : analysis.effects) {
    e.degreesOfFreedom = 1;
    for (const std::size_t f : e.factors) e.degreesOfFreedom *= static_cast<double>(design.levels[f] - 1);
    test(e, design, Contrasts(design, values, e.factors), analysis.squares, size);
  }
  return analysis;
}

std::vector<double> levelMeans(std::span<const std::size_t> levels, std::span<const double> values,
                               std::size_t factor) {
  const Design design(levels, values.size());
  std::vector<double> means(levels[factor]);
  for (std::size_t i = 0; i < values.size(); ++i) means[design.level(i / design.replicates, factor)] += values[i];
  for (double& m : means) m /= static_cast<double>(values.size() / means.size());
  return means;
}

}  // namespace morula
