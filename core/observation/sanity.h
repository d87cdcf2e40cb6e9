#pragma once
// The sanity check: bounds on a world with bodies at its end. The bounds are plain and wide, so that a world outside of
// them is wrong unless the scene is about just that.
#include <optional>
#include <string>
#include <vector>

#include "base/cell_path.h"
#include "base/choice.h"

namespace morula {

struct World;

/// The quantities of the sanity check. Names stand in results as "sanity NAME".
enum class SanityKind {
  finite,
  volume,
  inverted,
  folded,
  selfOverlap,
  overlap,
  gap,
  adhesion,
  outermost,
  fill,
  energy,
};
template <>
inline constexpr auto choices<SanityKind> = std::to_array<Choice<SanityKind>>({
    {SanityKind::finite, "finite", "numbers that are not finite"},
    {SanityKind::volume, "volume", "volume of a cell over its volume at rest"},
    {SanityKind::inverted, "inverted", "share of a surface that looks inward"},
    {SanityKind::folded, "folded", "share of a surface's edges that are folded over"},
    {SanityKind::selfOverlap, "self-overlap", "share of a cell's volume that the cell covers more than once"},
    {SanityKind::overlap, "overlap", "share of a cell's volume that another cell covers, too"},
    {SanityKind::gap, "gap", "empty space between cells"},
    {SanityKind::adhesion, "adhesion", "energy by which a cell sticks, over the most that its surface can hold"},
    {SanityKind::outermost, "outermost", "how far cells reach out of the shell"},
    {SanityKind::fill, "fill", "volume of all cells over that of the shell"},
    {SanityKind::energy, "energy", "growth of energy that nothing adds"},
});

namespace sanity {

constexpr double minVolume = 0.1, maxVolume = 10;  // [1] of a cell, over its volume at rest
constexpr double maxInverted = 0.25;               // [1] share of a cell's surface whose inner side shows outwards
// [1] Share of the edges of a cell's surface that turn by more than 90°: more than a fold all around the cell, which
// newborn and flattened cells may have (10 of the 120 edges of icosphere 1, 0.083; half as much on each finer one), and
// less than two. Only an icosahedron pressed flat has 0.2. Collapsed cells have 0.9.
constexpr double maxFolded = 0.15;
// [1] Share of a cell's volume that it covers more than once: half of what is to be told wherever it lies, for lines
// see a share of 0.005 as 0.0039 to 0.0060.
constexpr double maxSelfOverlap = 0.0025;
constexpr double maxAdhesion = 2;                  // [1] of the energy of a surface that sticks everywhere
constexpr double maxOverlap = 0.2;                 // [1] share of a cell's volume that lies in one other cell too
constexpr double maxOutermost = 1 + 1e-6;          // [shell radii] vertices are projected onto it, up to rounding
// [1] Share of the shell that all cells fill. Beyond 1 they share space, and contacts that press give way a little: 0.5
// % where cells of twice the shell's volume are pressed together (senses/pressed-and-old).
constexpr double maxFill = 1.02;
// [radii of the largest cell] of empty space with cells on both sides: no picture shows both
constexpr double maxGap = 1000;

}  // namespace sanity

/// One quantity, of the cell for which it is worst.
struct SanityMeasure {
  SanityKind kind = SanityKind::finite;
  double value = 0;  // NaN is outside of every bound
  double least = 0, most = 0;
  std::optional<CellPath> cell, other;  // `other`: the cell that it overlaps

  bool holds() const { return value >= least && value <= most; }
};

/// Measures all quantities that the world has; none without bodies or without cells. Volume comes first. A world with
/// numbers that are not finite is not measured further.
///
/// Overlap is measured by lines through pairs of cells (mesh/overlap.h), up to about 0.01. Shared space lies in both
/// cells' boxes, so only pairs are measured whose boxes share more than a fifth of the smaller cell, both along the
/// axes and along the way between the two. 0: no such pair. The pair with the most in common comes first, and the first
/// outside of the bound ends the search. Spheres have a formula.
///
/// A cell is tested for passing through itself only if it is not star-shaped about the mean of its vertices, by lines
/// along all three axes (measureSelfOverlap). Adhesion is measured for the pair law, which alone has an energy, from
/// the last snapshot.
///
/// Cost: each vertex a few times, and once more for each neighbour; 22 time steps at the end of thesis/elegans-128 (128
/// cells), of which four are for folds and self-overlap.
std::vector<SanityMeasure> measureSanity(const World& world);

/// Returns the measure `overlap` alone; absent with fewer than two cells, or where numbers are not finite.
std::optional<SanityMeasure> measureCellOverlap(const World& world);

/// Returns a sentence for a measure that does not hold. It names the cell, the number and its bound, and the keys that
/// change the number.
std::string describe(const SanityMeasure& measure, const World& world);

/// Returns the sentences of all measures that do not hold; empty if the world is sane.
std::string describeInsanity(const World& world);

}  // namespace morula
