#pragma once
// The exact test of differences that repeat. Counts, shares of few cells and times of few steps take few values. In a
// few seeds their variance may be 0 or nearly so by chance, and Student's t then shows a certainty that is none.
//
// If the differences of n pairs are as likely with either sign (no difference, and a symmetric distribution), each of
// the 2ⁿ choices of signs is as likely as the observed one [Fisher 1935]. p is the share of choices whose sum is as far
// from 0. No p is below 2^(1 − n): with 3 seeds 0.25, with 5 0.063, with 6 0.031, with 10 0.002.
#include <cstddef>
#include <span>

namespace morula {

/// Returns the smallest p that n differences can have by the test: 2^(1 − n).
double smallestSignFlipP(std::size_t n);

/// Returns the difference up to which two of these numbers count as equal: means of equal numbers that are summed in
/// another order differ by less.
double tieOf(std::span<const double> numbers);

/// Returns true if two of the n differences (vectors of `length` numbers) are equal but for rounding and sign.
bool repeats(std::span<const double> differences, std::size_t length = 1);

/// Returns the share of all choices of signs for which |Σ ± difference|² is at least as large as with the observed
/// signs. For more than 20 differences, which have too many choices to try, returns the smallest p.
double signFlipP(std::span<const double> differences, std::size_t length = 1);

}  // namespace morula
