#pragma once
// What makes a mesh fit to be a cell, with the place in a file for the message if it came from one.
#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace morula {

/// Where the parts of a mesh stand in its file. The vectors are empty for a mesh that is not from a file.
struct MeshSource {
  std::string name;              // of the file, or of the mesh
  std::vector<int> vertexLines;  // 1-based, per vertex
  std::vector<int> faceLines;    // 1-based, per triangle
  std::vector<int> faceNumbers;  // 1-based `f` line that a triangle is part of: a polygon has several
};

/// checkClosedManifold of mesh.h, whose errors begin with "name:line: " where the source knows lines.
void checkClosedManifold(const Mesh& mesh, const MeshSource& source);

}  // namespace morula
