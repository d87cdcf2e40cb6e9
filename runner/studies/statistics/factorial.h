#pragma once
// Which of several factors a value depends on, and whether one changes what another does: the analysis of variance of a
// balanced factorial design [Fisher 1935; Montgomery 2017, ch. 5].
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace morula {

/// One factor's main effect, or the interaction of two.
struct FactorEffect {
  std::vector<std::size_t> factors;  // one, or two that interact
  double squares = 0;                // sum of squares
  double degreesOfFreedom = 0;
  double share = 0;                 // η² [1]: of the sum of squares about the whole mean
  std::optional<double> partial{};  // partial η²: squares / (squares + error); absent without error
  std::optional<double> f{},
      p{};  // against the error; absent without one, or where nothing varies in the cells
};

struct FactorialAnalysis {
  std::vector<FactorEffect> effects;  // main effects in the order of the factors, then the pairs'
  double squares = 0;                 // about the whole mean
  double errorSquares = 0, errorDegreesOfFreedom = 0;
};

/// `levels`: how many each factor has, two at least. `values`: of cell (i, j, …) the replicates r = 0 … n − 1, the last
/// factor changing fastest and the replicate fastest of all: the product of levels times n. With `blocks`, replicate r
/// of every cell has the same random numbers (the same seed), and what the replicates have in common over all
/// cells is no error. n = 1: no error is known, and only shares are given.
FactorialAnalysis analyseFactorial(std::span<const std::size_t> levels, std::span<const double> values,
                                   bool blocks);

/// The mean of each level of one factor over all else.
std::vector<double> levelMeans(std::span<const std::size_t> levels, std::span<const double> values,
                               std::size_t factor);

}  // namespace morula
