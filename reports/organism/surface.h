#pragma once
// The triangles that are drawn for cells.
#include <cstdint>
#include <vector>

#include "organism/camera.h"
#include "organism/organism.h"

namespace morula {

/// One point of the surface, laid out as the cells' vertex shader reads it.
struct SurfaceVertex {
  float position[3];  // in eye space, relative to the framing's centre
  float normal[3];
  float corner[3];         // barycentric in the mesh's face, for drawing its edges
  std::uint16_t light[4];  // linear colour and opacity; 65535 is 1
  std::uint32_t owner;     // the cell's number, from 1
  float share;             // place of the colour on the scale of maps, 0 to 1; −1: `light` is the colour
};

/// The range of one cell's triangles in Surface::corners.
struct CellCorners {
  std::size_t cell, first, count;
};

struct Surface {
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint32_t> corners;  // three per triangle, solid cells first
  std::size_t solid = 0;               // number of corners of solid cells
  std::vector<CellCorners> cells;      // all cells that are drawn
  bool mapped = false;                 // true if any cell is a map
};

/// Returns the surface of all visible cells. Faces are bent between their vertices by Phong tessellation [Boubekeur &
/// Alexa 2008], so that silhouettes of coarse meshes are round; the mesh's vertices do not move, except to stay inside of
/// a shell that holds the cell (shell_wall.h). The more faces there are, the less each is split, because it is then small
/// in the picture. Without edges `corner` is not set, and unsplit faces share their vertices.
Surface makeSurface(const OrganismPicture& picture, const EyeAxes& axes, const Framing& framing, bool withEdges = true);

}  // namespace morula
