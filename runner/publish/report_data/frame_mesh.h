#pragma once
// The shapes of cells in frames, with fewer vertices where there are many cells: an icosphere's vertices are the first
// ones of the next level's, so that a cell on a fine mesh has a shape on a coarser one.
#include <cstddef>
#include <vector>

#include "mesh/mesh.h"

namespace morula {

/// A mesh of cells in frames.
struct FrameMesh {
  std::vector<Face> faces;
  std::vector<Point> ball;  // of spheres: vertices at distance 1 from the middle; empty: each cell has its own places
  bool operator==(const FrameMesh&) const = default;
};

/// Returns the number of vertices that a frame holds of a cell with this mesh: none of a ball, which has a middle and a
/// radius.
std::size_t placesOf(const FrameMesh& mesh);

/// Frames of cells with more vertices have coarser meshes.
inline constexpr std::size_t maxDrawnVertices = 200'000;
/// Spheres may have more vertices in a frame, since they are drawn alike and frames hold none of their places.
inline constexpr std::size_t maxBallVertices = 500'000;

/// Returns the ball that is drawn for each of so many spheres: an icosphere of level 2 (162 vertices) or 1 (42).
FrameMesh ballFor(std::size_t spheres);

/// Returns how many levels coarser the cells of a frame are that has so many vertices.
int levelsCoarser(std::size_t vertices);

/// Returns the shape on an icosphere that is up to so many levels coarser, with the same volume and mean of the vertices;
/// 42 vertices are the least. Shapes on other meshes stay as they are.
Mesh coarserShape(Mesh shape, int levels);

}  // namespace morula
