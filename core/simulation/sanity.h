#pragma once
// Whether a world with bodies is one that a reader of its results would take for fine. Bounds are plain and
// wide: what lies outside of them is wrong unless the scene is about just that.
#include <optional>
#include <string>
#include <vector>

#include "base/cell_path.h"

namespace morula {

struct World;

namespace sanity {

constexpr double leastVolume = 0.1, mostVolume = 10;  // [1] of a cell, over its volume at rest
constexpr double mostInverted = 0.25;                 // [1] share of a cell's surface whose inner side shows outwards
constexpr double mostOverlap = 0.2;                   // [1] share of a cell's volume that one other cell has too
constexpr double mostOutermost = 1 + 1e-6;            // [shell radii] vertices are projected onto it, up to rounding
// [1] Of the shell, by all cells: beyond 1 they share what is there, and contacts that press give way a little: 0.5 % where
// cells of twice the shell's volume are pressed together (senses/pressed-and-old).
constexpr double mostFill = 1.02;
// [radii of the largest cell] of empty space with cells on both sides: no picture shows both
constexpr double mostGap = 1000;

}  // namespace sanity

/// One quantity, of the cell where it is worst.
struct SanityMeasure {
  std::string name;  // "finite", "volume", "inverted", "overlap", "outermost", "fill", "gap"
  double value = 0;  // what is no number is outside of every bound
  double least = 0, most = 0;
  std::optional<CellPath> cell, other;  // `other`: the one that it overlaps

  bool holds() const { return value >= least && value <= most; }
};

/// All quantities that the world has; none without bodies or without cells. Volume first, and what is not
/// finite alone: a world with numbers that are none is not measured further.
///
/// Overlap is measured by lines through pairs of cells (mesh/overlap.h), up to about 0.01, and only of pairs
/// whose boxes have more than a fifth of the smaller cell in common, both along the axes and along the way
/// between the two: what cells have in common lies in both boxes. 0: of no pair. The pair with the most in
/// common comes first, and the first that is outside of the bound ends it. Spheres have a formula.
///
/// Cost: each vertex a few times, and once more for each neighbour; in a crowd of 64 cells as much as one to
/// three time steps.
std::vector<SanityMeasure> measureSanity(const World& world);

}  // namespace morula
