#pragma once
#include "division/cut.h"

namespace morula {

/// The plane with this unit normal through the mean of a body's vertices.
inline Cut throughMean(const Body& body, const Vector& normal) { return {measureCentroid(body.position), normal}; }

}  // namespace morula
