#pragma once
// The record of a division: how the cell was cut, and whether its shape decided that.
#include <cstdint>
#include <optional>

#include "base/cell_path.h"
#include "base/vec3.h"

namespace morula {

/// One division of a cell with a body.
struct DivisionRecord {
  CellPath path;                      // of the mother
  double time = 0;                    // [time]
  std::uint64_t step = 0;             // the physical step at whose end it happened
  Vector axis = {};                   // unit normal of the plane; points to daughter A
  double share = 0;                   // [1] of the mother's volume that daughter A has
  std::optional<double> extentRatio;  // [1] of the mother's two largest extents, 1 or more; absent: a sphere
  Point centreA = {}, centreB = {};   // [length] of the daughters as they were born; not in the database
  friend bool operator==(const DivisionRecord&, const DivisionRecord&) = default;
};

/// The polarity that a cell left to her daughters. Kept beside the divisions, because few scenes have polarities.
struct PolarityRecord {
  CellPath path;          // of the mother
  Vector direction = {};  // unit vector
  friend bool operator==(const PolarityRecord&, const PolarityRecord&) = default;
};

/// Below this ratio of the two largest extents the longest one is ambiguous: a change that moves a surface by 1 % (a
/// longer time step, another mesh) may turn the plane by a right angle.
constexpr double ambiguousExtentRatio = 1.01;

}  // namespace morula
