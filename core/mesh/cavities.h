#pragma once
// Empty space that closed meshes enclose, and where their common surface is: what a ball, the probe, cannot reach that
// comes from far away and enters no mesh, as solvent does in molecules [Lee, Richards 1971; Connolly 1983].
#include <span>
#include <vector>

#include "mesh/overlap.h"

namespace morula {

struct Cavities {
  double volume = 0;   // [length³] of all pockets: what probes cover that fit between the meshes, and cannot get out
  double largest = 0;  // [length³] of the largest
  std::vector<Point> outside;  // [length] centres of probes that came from outside and touch a mesh
  double edge = 0;             // [length] of the cubes
};

/// On a grid of cubes, whose edge h is a sixteenth of `probe` [length], the probe's radius, or as much longer as it
/// must be for there to be `most` cubes, in the box that holds the meshes and a probe's way around them; a cube is in a
/// mesh if its centre is. A pocket's volume is off by √3/2 h times its surface at most, distances from `outside` by 2h,
/// and what a rigid motion changes is no more than twice that. Gaps less wide than the probe are closed, and pockets
/// that it does not fit into are none, whatever the grid. With h above the probe nothing is found. Cost: 10 bytes and
/// some hundred operations for each cube, and the scan lines through the meshes.
Cavities measureCavities(std::span<const MeshView> meshes, double probe, double most = 2e6);

}  // namespace morula
