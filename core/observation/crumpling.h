#pragma once
// How crumpled cells are: where their surfaces fold over, where their membranes are compressed, and how much of a cell
// lies in itself. Balls have no surface that could crumple.
#include "observation/observation.h"

namespace morula {

/// [1] Edges shorter than this share of their rest length count as compressed.
constexpr double compressedEdge = 0.98;

/// Some of a surface's edges, and all of them.
struct EdgeCount {
  int some = 0, all = 0;

  /// Returns the share [1]; 0 without edges.
  double share() const { return all > 0 ? static_cast<double>(some) / all : 0; }
  EdgeCount& operator+=(const EdgeCount& o) { return some += o.some, all += o.all, *this; }
};

/// Counts the edges of a cell at which its surface turns by more than 90° (countFolded). Those that its mesh folds at
/// rest do not count. Requires bodies.
EdgeCount countFolded(const Observation& now, const ObservedCell& cell);
/// Counts the edges of a cell that are compressed below compressedEdge. Requires bodies.
EdgeCount countCompressed(const Observation& now, const ObservedCell& cell);

/// Sums a count over all cells. Requires bodies.
EdgeCount sumOverCells(const Observation& now, EdgeCount (*count)(const Observation&, const ObservedCell&));

/// Returns the share [1] of the space that a cell's surface winds around in which it does so more than once or inside
/// out, by 24 × 24 lines along each axis (measureSelfOverlap). 0 at little cost for cells that are star-shaped about
/// the mean of their vertices, which cannot cut through themselves, and for a ball.
double measureSelfOverlap(const BodyShape& shape);

}  // namespace morula
