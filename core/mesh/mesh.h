#pragma once
// A closed triangle mesh with vertex positions. Cells are loaded from, measured on and drawn as such meshes.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/members.h"
#include "base/vec3.h"

namespace morula {

using Face = std::array<std::int32_t, 3>;  // counter-clockwise seen from outside

struct Mesh {
  std::vector<Point> vertices;
  std::vector<Face> faces;
};
MORULA_MEMBERS(Mesh, vertices, faces)

/// The icosphere with unit radius: an icosahedron whose faces are split in four `level` times (0 to 4: 12, 42, 162,
/// 642, 2562 vertices) and whose vertices lie on the sphere. The vertices of each level begin with the vertices of the
/// level below. Throws InputError for another level.
Mesh makeIcosphere(int level);

/// Reads `v` and `f` lines of a Wavefront OBJ text. Polygons are cut into triangles (mesh/triangulate.h); names,
/// materials and the like are passed over. The mesh must pass `checkClosedManifold`. Returns it moved and scaled: mean
/// of the vertices at the origin, farthest vertex at distance 1. Throws InputError "name:line:column: …", one line per
/// mistake.
Mesh readObj(const std::string& text, const std::string& name);

/// Throws InputError "name: …", which names the edge, face or vertex (1-based, as in OBJ), unless the mesh is closed
/// (each edge has two faces), consistently oriented, manifold (one fan per vertex) and connected. It must have positive
/// volume, and no flat faces or unused vertices. Does not check that the surface never cuts through itself.
void checkClosedManifold(const Mesh& mesh, const std::string& name);

}  // namespace morula
