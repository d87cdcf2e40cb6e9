// Senses of cells that a cell touches, is connected to or was born with.
#include <algorithm>

#include "biology/sense.h"

namespace morula {
namespace {

double countNeighbours(const CellContext& cell, const SenseParameters&, const CountsCell& counts) {
  double count = 0;
  for (const Neighbour& n : cell.neighbours()) count += counts(*n.cell);
  return count;
}

/// Returns the largest contact [length²] with a counted cell; −1 without any.
double largestContact(const CellContext& cell, const SenseParameters&, const CountsCell& counts) {
  double largest = -1;
  for (const Neighbour& n : cell.neighbours())
    if (counts(*n.cell)) largest = std::max(largest, n.area);
  return largest;
}

/// Returns the counted cells' share [1] of all contact area; 0 where nothing touches the cell.
double shareOfContact(const CellContext& cell, const SenseParameters&, const CountsCell& counts) {
  double all = 0, theirs = 0;
  for (const Neighbour& n : cell.neighbours()) {
    all += n.area;
    if (counts(*n.cell)) theirs += n.area;
  }
  return all > 0 ? theirs / all : 0;
}

double countConnected(const CellContext& cell, const SenseParameters&, const CountsCell& counts) {
  double count = 0;
  for (const CellContext* other : cell.connected()) count += counts(*other);
  return count;
}

/// Returns 1 if the other daughter of the cell's mother is as asked for; 0 if not, and for a cell without a mother.
double sister(const CellContext& cell, const SenseParameters& sense, const CountsCell& counts) {
  if (cell.path.isEgg()) return 0;
  const CellContext* sister = cell.sister();
  if (sense.of.empty()) return (sister != nullptr) == sense.lives;
  return sister && counts(*sister);
}

Threshold areaAtLeast(const SenseParameters& sense) { return {.atLeast = sense.number.value_or(0)}; }
Threshold moreThanHalf(const SenseParameters&) { return {.above = 0.5}; }
Threshold oneAtLeast(const SenseParameters&) { return {.atLeast = 1}; }

// clang-format off
constexpr SenseKindRow neighbourRows[] = {
    {.kind = SenseKind::neighbours, .name = "neighbours",
     .meaning = "Number of cells that touch the cell; with `of` only of cells that hold that substance",
     .needs = SenseNeeds::contact, .of = {"of"}, .least = 0, .measure = countNeighbours},
    {.kind = SenseKind::contact, .name = "contact",
     .meaning = "A cell that holds `of` touches the cell, over at least this `area` if one is given",
     .needs = SenseNeeds::contact, .of = {"of", true}, .number = {"area", "length²"},
     .measure = largestContact, .threshold = areaAtLeast},
    {.kind = SenseKind::majority, .name = "majority",
     .meaning = "Cells that hold `of` have more than half of the cell's contact area [Nilsson 2008, §6.2.5]",
     .needs = SenseNeeds::contact, .of = {"of", true}, .measure = shareOfContact, .threshold = moreThanHalf},
    {.kind = SenseKind::connected, .name = "connected",
     .meaning = "The cell is connected to a cell that holds `to`, or, without `to`, to any cell",
     .needs = SenseNeeds::connections, .of = {"to"}, .measure = countConnected, .threshold = oneAtLeast},
    {.kind = SenseKind::sister, .name = "sister",
     .meaning = "The cell's sister lives and `holds` this substance; or she `lives`; or, with `lives: false`, she "
                "has divided or died",
     .of = {"holds"}, .takesLives = true, .measure = sister, .threshold = oneAtLeast},
};
// clang-format on

}  // namespace

std::span<const SenseKindRow> neighbourSenses() { return neighbourRows; }

}  // namespace morula
