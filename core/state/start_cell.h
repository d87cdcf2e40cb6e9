#pragma once
// A scene may begin with several start cells instead of one egg.
#include <optional>
#include <string>
#include <vector>

#include "base/members.h"
#include "base/vec3.h"

namespace morula {

/// A start cell is the egg at another place, of another size or shape.
struct StartCell {
  Point at = {};            // [length] its centre
  Vector velocity = {};     // [length/time] of all its vertices
  double scale = 1;         // its size at rest over the egg's: lengths; the fluid's k_p and mass go with the cube
  Vector turn = {};         // [degree] turn of its mesh about this axis, by the axis' length; before stretching
  Vector stretch{1, 1, 1};  // of its shape along x, y and z; its shape at rest stays
  std::optional<double> mass = {};                          // [mass]; absent: the egg's times scale³
  std::optional<std::vector<std::string>> substances = {};  // sorted; absent: what the DNA starts with
};
MORULA_MEMBERS(StartCell, at, velocity, scale, turn, stretch, mass, substances)

}  // namespace morula
