#pragma once
// Of several measurements of one thing the middle one counts: what disturbed some of them does not.
#include <vector>

namespace morula {

/// NaN of nothing.
double median(std::vector<double> values);

/// Half the distance between the quartiles, over the median: how far measurements lay apart. [1]
double spread(std::vector<double> values);

}  // namespace morula
