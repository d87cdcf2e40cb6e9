#pragma once
// Deviations by which no two organisms are alike; a seed decides them [base/random.h, randomDeviate]. Each deviation
// belongs to a cell's lineage path and to what deviates, so a cell has the same one whatever else the scene does.
#include "base/members.h"

namespace morula {

/// Standard deviations; 0: none.
struct VariationParameters {
  double cycle = 0;     // [1] of a cell's cycle lengths, over those of its state; one number for all its life
  double share = 0;     // [1] of daughter A's share, about the given one or a half
  double start = 0;     // [egg radii] of the places of the first cells, along x, y and z
  double tilt = 0;      // [degree] of division axes whose rule gives none
  double adhesion = 0;  // [1] of how strongly a cell sticks; two cells stick by the mean of their factors
  friend bool operator==(const VariationParameters&, const VariationParameters&) = default;
};
MORULA_MEMBERS(VariationParameters, cycle, share, start, tilt, adhesion)

}  // namespace morula
