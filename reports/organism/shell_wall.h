#pragma once
// The drawn shell, and the cells that it holds, which are drawn inside of it. A shell holds the surface below a cell's
// vertices (core/physics/sag.h), and faces are bent outwards between them, so without this rule parts of a cell that
// presses against the shell would come out of the wall in patches.
#include "organism/camera.h"
#include "organism/organism.h"

namespace morula {

/// The wall lies outside of the shell, this many times as far from the middle.
inline constexpr double shellThickness = 1.02;
/// Cells that the shell holds are drawn up to here: half of the gap between shell and wall stays free everywhere.
inline constexpr double heldReach = 1.01;
/// A cell with a vertex beyond this is not held but stands out of the shell, and is drawn as it is. Held vertices do not
/// come so far: twelve in a cell as large as its shell, the coarsest mesh, reach 1.18.
inline constexpr double freeReach = 1.2;

class ShellWall {
 public:
  ShellWall(const OrganismPicture& picture, const EyeAxes& axes, const Framing& framing);

  /// Returns the place of a point [length] between the shell's middle, 0, and the shell, 1; 0 without a shell.
  double reach(const Point& point) const;

  /// Returns true if the shell holds a cell: its middle is in the shell and no vertex beyond freeReach.
  bool holds(const CellShape& cell) const;

  /// Returns a point in eye space [length], or, if it is beyond heldReach, the point there on the line to the middle.
  Vector inside(const Vector& point) const;

 private:
  const OrganismPicture& picture_;
  EyeAxes axes_;
  Vector middle_;      // of the shell, in eye space
  double within_ = 0;  // [length] from the middle; all nearer points are in the shell
};

}  // namespace morula
