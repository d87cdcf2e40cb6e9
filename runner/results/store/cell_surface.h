#pragma once
// A cell's surface as the database keeps it: 16 bits a coordinate over the cell's own box, six bytes a vertex.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/cell_path.h"
#include "mesh/mesh.h"

namespace morula {

/// The faces of a mesh of the scene, stored once for all cells that have it.
struct MeshFaces {
  int mesh = 0;                // Body::meshLevel: 0 the egg's mesh, 1 … the coarser ones
  std::uint64_t vertices = 0;  // number of vertices of each surface
  std::vector<Face> faces;
  friend bool operator==(const MeshFaces&, const MeshFaces&) = default;
};

/// A surface whose coordinates are low + number · step, along x, y and z each. `step` [length] is the 65535th part of
/// the surface's extent, so a coordinate is off by at most step / 2 and the rounding of a double.
struct CellSurface {
  CellPath path;
  int mesh = 0;  // MeshFaces::mesh
  Point low;     // [length]
  Vector step;   // [length]
  std::vector<std::array<std::uint16_t, 3>> numbers;
  friend bool operator==(const CellSurface&, const CellSurface&) = default;
};

/// Requires at least one vertex, and finite coordinates.
CellSurface quantise(const CellPath& path, int mesh, const std::vector<Point>& vertices);
std::vector<Point> vertexPositions(const CellSurface& surface);

// The bytes of a surface, little-endian: x, y and z of each vertex; the corners of each face, in 16 bits where the mesh
// has at most 65536 vertices and in 32 where it has more.
std::string numberBytes(const CellSurface& surface);
std::string faceBytes(const MeshFaces& mesh);
/// Reads the vertices of a surface; the number of bytes must be a multiple of six.
std::vector<std::array<std::uint16_t, 3>> numbersFrom(std::string_view bytes);
/// Reads faces. Returns false if the bytes are no faces with corners below `vertices`.
bool facesFrom(std::string_view bytes, std::uint64_t vertices, std::vector<Face>& faces);

}  // namespace morula
