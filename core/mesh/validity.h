#pragma once
// Checks that a mesh can be a cell. Messages name the place in its file if it came from one.
#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh.h"

namespace morula {

/// How finely a file's coordinates are written: max decimals and max significant digits of all of them. Exporters round
/// all coordinates alike, to a number of decimals or of digits, and may leave out zeros at the end.
struct WrittenDigits {
  int decimals = 0, significant = 0;

  /// Takes one coordinate into account, as "-1.25" or "3e-4".
  void note(std::string_view number);
  /// Returns by how much [length] the coordinate may differ from the number before rounding.
  double roundingOf(double coordinate) const;
};

/// The lines of a file in which the parts of a mesh stand. The vectors are empty for a mesh that is not from a file.
struct MeshSource {
  std::string name;              // of the file, or of the mesh
  std::vector<int> vertexLines;  // 1-based, per vertex
  std::vector<int> faceLines;    // 1-based, per triangle
  std::vector<int> faceNumbers;  // 1-based `f` line that a triangle is part of: a polygon has several
  WrittenDigits written = {};    // of the vertices' coordinates
};

/// checkClosedManifold of mesh.h, whose errors begin with "name:line: " where the source knows lines.
void checkClosedManifold(const Mesh& mesh, const MeshSource& source);

}  // namespace morula
