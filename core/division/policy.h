#pragma once
// Where a cell divides: the direction from daughter B to daughter A, at right angles to the plane.
#include <cstdint>
#include <memory>

#include "base/cell_path.h"
#include "division/parameters.h"
#include "physics/bodies.h"

namespace morula {

class DivisionPolicy {
 public:
  virtual ~DivisionPolicy() = default;
  /// The plane's unit normal; the plane goes through the cell's centre of mass. Daughter A lies where it
  /// points.
  virtual Vector planeNormal(const CellPath& cell, const Body& body) const = 0;
};

/// Throws InputError for an axis of length 0.
std::unique_ptr<DivisionPolicy> makeDivisionPolicy(const DivisionParameters& parameters, std::uint64_t seed);

}  // namespace morula
