#pragma once
// Where N cells of one size begin that were not grown by divisions: spread evenly through a ball, in the order that
// divisions would give.
#include <vector>

#include "base/cell_path.h"
#include "base/vec3.h"

namespace morula {

struct PlacedCell {
  CellPath path;
  Point centre;
};

/// `count` ≥ 1 centres in the unit ball, by path. Without chance: an additive recurrence spreads them
/// [Roberts 2018], those too near push each other apart, and halving across the longest side of what is left
/// names them, as division across the longest axis would.
std::vector<PlacedCell> packBall(int count);

/// [length] of the sphere whose volume is a share 1/count of the unit ball's.
double shareRadius(int count);

}  // namespace morula
