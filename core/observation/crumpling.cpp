#include "observation/crumpling.h"

#include <algorithm>

#include "mesh/folds.h"
#include "mesh/overlap.h"

namespace morula {
namespace {

constexpr int linesPerCell = 24;  // along each axis

}  // namespace

EdgeCount countFolded(const Observation& now, const ObservedCell& cell) {
  const Bodies& b = *now.world.bodies;
  if (b.areSpheres()) return {};
  const Mesh& surface = cell.physical()->getShape().surface;
  const EdgeFaces& edges = now.flatEdges(b.blocks[cell.slot() / blockLanes].meshLevel);
  return {countFolded(surface.vertices, surface.faces, edges), static_cast<int>(edges.size())};
}

EdgeCount countCompressed(const Observation& now, const ObservedCell& cell) {
  const Bodies& b = *now.world.bodies;
  if (b.areSpheres()) return {};
  const MeshTemplate& mesh = b.meshOf(cell.slot());
  const std::vector<Point>& vertices = cell.physical()->getShape().surface.vertices;
  EdgeCount count{0, mesh.edgeCount()};
  for (int e = 0; e < count.all; ++e) {
    const double length = norm(vertices[mesh.edges[2 * e]] - vertices[mesh.edges[2 * e + 1]]);
    count.some += length < compressedEdge * b.restScale[cell.slot()] * mesh.restLengths[e];
  }
  return count;
}

EdgeCount sumOverCells(const Observation& now, EdgeCount (*count)(const Observation&, const ObservedCell&)) {
  EdgeCount sum;
  for (int i = 0; i < now.world.bodies->count; ++i) sum += count(now, ObservedCell(now, i));
  return sum;
}

double measureSelfOverlap(const BodyShape& shape) {
  const MeshView surface{shape.surface.vertices, shape.surface.faces};
  return shape.isBall || isStarShaped(surface, shape.centre) ? 0 : measureSelfOverlap(surface, linesPerCell);
}

}  // namespace morula
