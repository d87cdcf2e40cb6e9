#pragma once
// Convergence as pure functions: slopes, the rest of an error, and cost at an error. Powers
// become straight lines in logarithms, so all numbers are > 0 unless it says otherwise.
#include <optional>
#include <vector>

namespace morula {

struct XY {
  double x = 0, y = 0;
};

/// y = C x^slope.
struct PowerLaw {
  double slope = 0;
  double slopeError = 0;  // standard error; 0 through two points
  int points = 0;
};

/// By least squares in logarithms; points that are not > 0 and finite are left out. Nothing of fewer than two
/// different x.
std::optional<PowerLaw> fitPowerLaw(const std::vector<XY>& points);

/// Estimates the error of the finest of three solutions whose steps were halved twice.
struct LeftError {
  double error = 0;  // of the finest; as `coarseToMiddle` and `middleToFine`
  double order = 0;  // observed; 0: it does not converge
};

/// Richardson's estimate [Richardson 1911]: with e(h) ∝ h^p, |y_h − y_{h/2}| = (2^p − 1) e(h/2), and two such
/// distances give p. `highestOrder` is the method's own: a higher one that is observed is chance. Both
/// distances 0: no error; falling by less than 2^¼: the larger distance itself, and order 0.
LeftError estimateByRichardson(double coarseToMiddle, double middleToFine, double highestOrder);

/// One run: what it cost, and how far off it was.
struct WorkPoint {
  double cost = 0, error = 0;
};

/// The least cost at which a series of runs, in order of their steps, has that error: on the straight lines between
/// neighbours in logarithms. Nothing if no two neighbours have it between them: there is no extrapolation.
std::optional<double> costAtError(const std::vector<WorkPoint>& series, double error);

}  // namespace morula
