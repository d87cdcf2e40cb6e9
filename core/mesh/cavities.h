#pragma once
// Measures the empty space that closed meshes enclose, and finds their common surface. Both depend on a ball, the
// probe, that comes from far away and enters no mesh, as solvent does in molecules [Lee, Richards 1971; Connolly 1983].
#include <span>
#include <vector>

#include "mesh/overlap.h"

namespace morula {

struct Cavities {
  double volume = 0;   // [length³] of all pockets: space of probes that fit between the meshes and cannot get out
  double largest = 0;  // [length³] of the largest pocket
  std::vector<Point> outside;  // [length] centres of probes that came from outside and touch a mesh
  double edge = 0;             // [length] edge of the cubes
};

/// Measures on a grid of at most `most` cubes, with room for a probe's way around the meshes. The edge h of a cube is a
/// sixteenth of `probe` [length], the probe's radius, or as much longer as `most` requires. A cube is in a mesh if its
/// centre is. A pocket's volume is off by at most √3/2 h times its surface, distances from `outside` by 2h, and a rigid
/// motion changes them by at most twice that. Gaps narrower than the probe are closed, and pockets that it does not fit
/// into are not found, on any grid. With h above the probe nothing is found. Cost: 10 bytes and some hundred operations
/// for each cube, and the scan lines through the meshes.
Cavities measureCavities(std::span<const MeshView> meshes, double probe, double most = 2e6);

}  // namespace morula
