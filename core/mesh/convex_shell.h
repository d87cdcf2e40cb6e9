#pragma once
// A closed, convex surface around the origin, as the half-spaces n·x ≤ d whose intersection it bounds.
#include <string>
#include <vector>

#include "base/members.h"
#include "mesh/mesh.h"

namespace morula {

/// A point x is inside where normal·x ≤ offset.
struct ShellPlane {
  Vector normal;  // of length 1, outward
  double offset;  // [length] > 0, of the plane from the origin

  bool operator==(const ShellPlane&) const = default;
};
MORULA_MEMBERS(ShellPlane, normal, offset)

struct ConvexShell {
  Mesh mesh;
  std::vector<ShellPlane> planes;  // one for all faces in one plane, in the order of the first of them
};
MORULA_MEMBERS(ConvexShell, mesh, planes)

/// Reads a Wavefront OBJ text as readObj does, but neither moves nor scales it. Throws InputError "name:line:column: …"
/// where readObj does, and for the first face with a vertex outside of its plane (not convex) by more than 1e-9 of the
/// shell's size and more than the digits explain with which the file writes coordinates (at most 1e-3 of the size), or
/// whose plane has the origin outside or within 1e-3 of that size. The size: from the origin to the farthest vertex,
/// 1e-6 to 1e6.
ConvexShell readConvexShell(const std::string& text, const std::string& name);

/// Returns the shell `factor` > 0 times as large.
ConvexShell scaleConvexShell(ConvexShell shell, double factor);

/// [1] The largest normal·x / offset: at most 1 inside, and linear along a ray from the origin.
double measureReach(const std::vector<ShellPlane>& planes, const Point& x);

/// The plane with the least distance to a point inside; the first of equals.
const ShellPlane& nearestPlane(const std::vector<ShellPlane>& planes, const Point& x);

}  // namespace morula
