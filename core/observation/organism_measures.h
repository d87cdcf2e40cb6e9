#pragma once
// Measures of all cells together: contacts, and the places of relatives. Requires bodies. Clones are the living
// descendants of each cell at some depth; cells nearer to the egg belong to no clone.
#include <optional>
#include <span>

#include "observation/observation.h"
#include "biology/cell_selection.h"

namespace morula {

/// Returns the divisions from the egg to the youngest common ancestor of two cells, which may be one of them.
int commonDepth(const CellPath& a, const CellPath& b);

/// Returns the share [1] of the living pairs of sisters (relation 1), or of cousins with one grandmother and two
/// mothers (relation 2), that touch; absent without such a pair.
std::optional<double> measureRelativesInContact(const Observation& now, int relation);
/// Returns the share [1] within one clone of the contact area between cells of clones; absent where none touch.
std::optional<double> measureCloneContact(const Observation& now, int depth);
/// Returns the share [1] of all contact area that is between cells with the same substances; absent where none touch.
std::optional<double> measureHomotypicContact(const Observation& now);
/// Returns the share [1] of contacts between cells of clones that join different clones, over the share of all pairs of
/// these cells that do. 0: clones are apart; 1: as if cells were dealt out at random. Absent where none touch or only
/// one clone lives.
std::optional<double> measureMixing(const Observation& now, int depth);
/// Returns the root mean square distance [length] of the centres of a clone's cells from their mean, averaged over the
/// clones with two living cells at least; absent without one.
std::optional<double> measureCloneRadius(const Observation& now, int depth);
/// Returns into how many pieces [1] a clone falls by its contacts, averaged over the living clones; absent without one.
std::optional<double> measureClonePieces(const Observation& now, int depth);
/// Returns the root mean square distance [1] of a clone's volume from its centre, over that of a ball with this volume:
///
///   √(Σ (Sᵢ + Vᵢ |xᵢ − x|²) / V) / √(3/5) R,   V = Σ Vᵢ,  x = Σ Vᵢ xᵢ / V,  4/3 π R³ = V
///
/// with the volume Vᵢ, its centre xᵢ and its second moment Sᵢ = ∫ |y − xᵢ|² dV of each of its cells; averaged over the
/// living clones. 1 for a ball, whatever it is divided into, and more for anything else. Space that lies in two cells
/// counts twice.
std::optional<double> measureCloneSpread(const Observation& now, int depth);
/// Shares [1] of Observation::cavities in the volume of the cells and the pockets: all pockets, and the largest. Absent
/// without cells, or with too many for the grid of cavities (some 60 000 in a ball).
struct Lumen {
  double all, largest;
};
std::optional<Lumen> measureLumen(const Observation& now);
/// Returns the rank correlation [1] of kinship, counted in divisions on the way from one cell to the other, with the
/// distance of centres, over all pairs; absent where all are equally close. O(n² log n)
std::optional<double> measureLineageInSpace(const Observation& now);
/// Returns the largest over the second largest extent [1] of all cells' vertices together.
std::optional<double> measureOrganismElongation(const Observation& now);

/// Contacts of the world between living cells that occur in the reference, compared with the reference's contacts
/// between living cells.
struct ContactsCompared {
  double both = 0, here = 0, there = 0;  // pairs that touch in both, in the world, in the reference
};
ContactsCompared compareContacts(const Observation& now);
/// The centres of living cells laid upon the reference's, by the cells that both have.
struct PositionsCompared {
  double distance, shape, scale;  // as Superposition
  std::size_t cells;              // cells that both have
};
std::optional<PositionsCompared> comparePositions(const Observation& now);
/// Compares the mirror image of the centres with the reference.
std::optional<PositionsCompared> compareMirroredPositions(const Observation& now);

/// Returns how far y rises with x [1], whatever the curve: the correlation of their ranks, −1 to 1 [Spearman 1904].
/// Equal values have the mean of their ranks. Neighbours in order that differ by at most 1e-9 of the largest count as
/// equal: rounding must not decide. Absent where all x or all y are equal. Requires as many x as y. O(n log n)
std::optional<double> rankCorrelation(std::span<const double> x, std::span<const double> y);

}  // namespace morula
