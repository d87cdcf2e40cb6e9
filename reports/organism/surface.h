#pragma once
// From cells to the triangles that are drawn.
#include <cstdint>
#include <vector>

#include "organism/camera.h"
#include "organism/organism.h"

namespace morula {

/// One point of the surface, laid out as the cells' vertex shader reads it.
struct SurfaceVertex {
  float position[3];  // in eye space, relative to the framing's centre
  float normal[3];
  float corner[3];         // barycentric in the face of the mesh, so that its edges can be drawn
  std::uint16_t light[4];  // linear colour and opacity, 65535 is 1
  std::uint32_t owner;     // the cell's number, from 1
  float share;             // where its colour lies on the scale of maps, 0 to 1; −1: `light` is its colour
};

/// The range of one cell's triangles among the corners.
struct CellCorners {
  std::size_t cell, first, count;
};

struct Surface {
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint32_t> corners;  // three vertices to a triangle, solid cells first
  std::size_t solid = 0;               // corners of solid cells
  std::vector<CellCorners> cells;      // of those that are drawn
  bool mapped = false;                 // whether any cell is a map
};

/// Bends each face between its vertices by Phong tessellation [Boubekeur & Alexa 2008], so that silhouettes
/// are round although the mesh is coarse; the mesh's own vertices stay where they are. The more faces there
/// are, the less each is split, because it is then small in the picture. Without edges `corner` is not set, and faces
/// that are not split share their vertices.
Surface makeSurface(const OrganismPicture& picture, const EyeAxes& axes, const Framing& framing, bool withEdges = true);

}  // namespace morula
