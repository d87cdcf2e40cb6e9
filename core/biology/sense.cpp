#include "biology/sense.h"

#include <algorithm>
#include <vector>

#include "base/error.h"

namespace morula {

std::span<const SenseKindRow* const> senseKinds() {
  static const std::vector<const SenseKindRow*> all = [] {
    std::vector<const SenseKindRow*> rows;
    for (const auto group : {bodySenses(), neighbourSenses(), distantSenses()})
      for (const SenseKindRow& row : group) rows.push_back(&row);
    return rows;
  }();
  return all;
}

const SenseKindRow& kindOf(SenseKind kind) {
  const auto row = std::ranges::find(senseKinds(), kind, [](const SenseKindRow* r) { return r->kind; });
  MORULA_CHECK(row != senseKinds().end(), "each kind of sense has a row");
  return **row;
}

bool holds(const Threshold& t, double value, bool before) {
  const bool now = (!t.below || value < *t.below) && (!t.above || value > *t.above) &&
                   (!t.atMost || value <= *t.atMost) && (!t.atLeast || value >= *t.atLeast);
  if (now || !before || !t.until) return now;
  return t.below || t.atMost ? value <= *t.until : value >= *t.until;
}

bool isSensed(const SenseParameters& sense, const CellContext& cell, const CountsCell& counts, bool before) {
  const SenseKindRow& row = kindOf(sense.kind);
  if (row.needs != SenseNeeds::nothing && !cell.physical()) return false;
  return holds(row.threshold ? row.threshold(sense) : sense.is, row.measure(cell, sense, counts), before);
}

}  // namespace morula
