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
  double offset;  // [length] > 0, distance of the plane from the origin

  bool operator==(const ShellPlane&) const = default;
};
MORULA_MEMBERS(ShellPlane, normal, offset)

struct ConvexShell {
  Mesh mesh;
  std::vector<ShellPlane> planes;  // one plane for all faces in it, in the order of their first faces
};
MORULA_MEMBERS(ConvexShell, mesh, planes)

/// Reads a Wavefront OBJ text as readObj does, but neither moves nor scales it. The shell's size is the distance from
/// the origin to the farthest vertex, 1e-6 to 1e6. Throws InputError "name:line:column: …" where readObj does, and for
/// the first face that is not convex, or whose plane has the origin outside or within 1e-3 of the size. Not convex: a
/// vertex is outside of the face's plane by more than 1e-9 of the size and more than the file's digits explain (at most
/// 1e-3 of the size).
ConvexShell readConvexShell(const std::string& text, const std::string& name);

/// Returns the shell `factor` > 0 times as large.
ConvexShell scaleConvexShell(ConvexShell shell, double factor);

/// Returns the largest normal·x / offset [1]: at most 1 inside, and linear along a ray from the origin.
double measureReach(const std::vector<ShellPlane>& planes, const Point& x);

/// Returns the plane with the least distance to a point inside; of equals the first.
const ShellPlane& nearestPlane(const std::vector<ShellPlane>& planes, const Point& x);

}  // namespace morula
