#pragma once
// Factorial designs: the factors that a value depends on, and their interactions, by the analysis of variance of a
// balanced factorial design [Fisher 1935; Montgomery 2017, ch. 5] whose replicates are blocks: replicate r of every
// cell has the same random numbers (the same seed), and what all cells of a replicate have in common is no error.
//
// Each effect is tested against its own variation from seed to seed, not against one error of the whole table. Common
// random numbers make some conditions vary alike and others not; a pooled error then finds differences in half of all
// studies without any. An effect of d degrees of freedom in n seeds has F = (squares / d) / (error / (d (n − 1))). If
// some of its d contrasts vary more than others, F follows Fisher's distribution with ε d and ε d (n − 1) degrees of
// freedom, 1/d ≤ ε ≤ 1 [Box 1954]. Estimates of ε are too small [Greenhouse & Geisser 1959] or, with few seeds, too
// large [Huynh & Feldt 1976; Lecoutre 1991]: ε = 0.25 ε_GG + 0.75 ε_HF. For d up to 4, simulated studies without any
// effect (calibration_test.cpp) have p < 0.05 in 3.3 to 6.5 % from 5 seeds on, and in 10 % at most with 3. With d = 8
// and one contrast that varies more than all others: 7 % with 5 seeds, 11 % with 3.
//
// The interval is of partial η² in infinitely many seeds, σ² / (σ² + error), with the variance σ² of the effect's
// contrasts and the error's variance, both of one seed. Its bounds are λ / (λ + d n), with the noncentralities λ for
// which F is the 97.5 % and the 2.5 % quantile [Steiger 2004; ε d for d, as in the test]. It holds the true value in 93
// to 98 % of simulated studies from 5 seeds on, 93 to 98.5 % with 3 (calibration_test.cpp).
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "statistics/means.h"

namespace morula {

/// One factor's main effect, or the interaction of two.
struct FactorEffect {
  std::vector<std::size_t> factors;           // one, or two that interact
  double squares = 0;                         // sum of squares
  double degreesOfFreedom = 0;                // d
  double share = 0;                           // η² [1]: share of the sum of squares about the whole mean
  double errorSquares = 0;                    // sum of squares of the effect's variation from seed to seed
  double errorDegreesOfFreedom = 0;           // d (n − 1)
  double epsilon = 1;                         // ε
  std::optional<double> partial{};            // partial η²: squares / (squares + error); absent without error
  std::optional<Interval> partialInterval{};  // 95 %
  std::optional<double> f{}, p{};             // absent if the effect varies by less than a millionth; p as in means.h
};

struct FactorialAnalysis {
  std::vector<FactorEffect> effects;  // main effects in the order of the factors, then interactions of pairs
  double squares = 0;                 // about the whole mean
};

/// `levels`: number of levels of each factor, two at least. `values`: for cell (i, j, …) the replicates r = 0 … n − 1,
/// the last factor changing fastest and the replicate fastest of all; in total the product of levels times n. With n =
/// 1 no error is known, and only shares are given.
FactorialAnalysis analyseFactorial(std::span<const std::size_t> levels, std::span<const double> values);

/// Returns the mean of each level of one factor over all other factors and replicates.
std::vector<double> levelMeans(std::span<const std::size_t> levels, std::span<const double> values, std::size_t factor);

}  // namespace morula
