#pragma once
// Convergence as pure functions: slopes, remaining errors, and cost at an error. Powers become straight lines in
// logarithms, so all numbers are > 0 unless noted.
#include <optional>
#include <vector>

namespace morula {

struct XY {
  double x = 0, y = 0;
};

/// A power law y = C x^slope.
struct PowerLaw {
  double slope = 0;
  double slopeError = 0;  // standard error; 0 for two points
  int points = 0;
};

/// Fits a power law by least squares in logarithms, without points that are not > 0 and finite. Returns nothing for
/// fewer than two different x.
std::optional<PowerLaw> fitPowerLaw(const std::vector<XY>& points);

/// Estimates the error of the finest of three solutions whose steps were halved twice.
struct LeftError {
  double error = 0;  // error of the finest, in the unit of the distances
  double order = 0;  // observed order; 0: no convergence
};

/// Richardson's estimate [Richardson 1911]: with e(h) ∝ h^p, |y_h − y_{h/2}| = (2^p − 1) e(h/2), and two such distances
/// give p. `highestOrder`: the method's own order, since a higher observed order is chance. If both distances are 0
/// there is no error. If they fall by less than 2^¼ the error is the larger distance, and the order 0.
LeftError estimateByRichardson(double coarseToMiddle, double middleToFine, double highestOrder);

/// The cost and the error of one run.
struct WorkPoint {
  double cost = 0, error = 0;
};

/// Returns the least cost at which a series of runs, in order of their steps, reaches the error, on straight lines
/// between neighbours in logarithms. Returns nothing if no two neighbours enclose the error: nothing is extrapolated.
std::optional<double> costAtError(const std::vector<WorkPoint>& series, double error);

}  // namespace morula
