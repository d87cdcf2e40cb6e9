#pragma once
// Measures of all cells together: contacts, and the places of relatives. The observation's world has bodies. Clones:
// the living descendants of each cell at some depth; cells nearer to the egg belong to none.
#include <optional>
#include <span>

#include "simulation/observation.h"

namespace morula {

constexpr int cloneDepth =
    2;  // [divisions] from the egg to a clone's founder if nothing else is said: four clones at most

/// Divisions on the way from the egg to the youngest common ancestor of two cells, which may be one of them.
int commonDepth(const CellPath& a, const CellPath& b);

/// [1] Of the living pairs of sisters (relation 1), or of cousins with one grandmother and two mothers (relation 2),
/// the share that touch; absent without such a pair.
std::optional<double> measureRelativesInContact(const Observation& now, int relation);
/// [1] Of the contact area between cells of clones, the share within one clone; absent where none touch.
std::optional<double> measureCloneContact(const Observation& now, int depth);
/// [1] Of all contact area, the share between cells with the same substances; absent where none touch.
std::optional<double> measureHomotypicContact(const Observation& now);
/// [1] Of the contacts between cells of clones, the share that join different clones, over the share of all
/// pairs of those cells that do: 0 clones apart, 1 as if cells were dealt out at random. Absent where none touch
/// or only one clone lives.
std::optional<double> measureMixing(const Observation& now, int depth);
/// [length] Root mean square distance of the centres of a clone's cells from their mean, in the mean over
/// the clones with two living cells at least; absent without one.
std::optional<double> measureCloneRadius(const Observation& now, int depth);
/// [1] Pieces into which a clone falls by its contacts, in the mean over the clones that live; absent without one.
std::optional<double> measureClonePieces(const Observation& now, int depth);
/// [1] Root mean square distance of a clone's volume from its centre, over that of a ball with this volume:
///
///   √(Σ (Sᵢ + Vᵢ |xᵢ − x|²) / V) / √(3/5) R,   V = Σ Vᵢ,  x = Σ Vᵢ xᵢ / V,  4/3 π R³ = V
///
/// with the volume Vᵢ, its centre xᵢ and its second moment Sᵢ = ∫ |y − xᵢ|² dV of each of its cells; in the mean over
/// the clones that live. 1 for a ball, whatever it is divided into, and more for anything else. What lies in two cells
/// counts twice.
std::optional<double> measureCloneSpread(const Observation& now, int depth);
/// [1] Of Observation::cavities: all pockets, and the largest, over the volume of the cells and the pockets. Absent
/// where the cells are too many for its grid (some 60 000 in a ball), and without any.
struct Lumen {
  double all, largest;
};
std::optional<Lumen> measureLumen(const Observation& now);
/// [1] Rank correlation of kinship, counted in divisions on the way from one cell to the other, with the
/// distance of centres, over all pairs; absent where all are equally close. O(n² log n)
std::optional<double> measureLineageInSpace(const Observation& now);
/// [1] The largest over the second largest extent of all cells' vertices together.
std::optional<double> measureOrganismElongation(const Observation& now);

/// Contacts between living cells that occur in the reference, compared with those of the reference between living
/// cells.
struct ContactsCompared {
  double both = 0, here = 0, there = 0;  // pairs that touch in both, in the world, in the reference
};
ContactsCompared compareContacts(const Observation& now);
/// The centres of living cells laid upon the reference's, by those that both have.
struct PositionsCompared {
  double distance, shape, scale;  // as Superposition
  std::size_t cells;              // that both have
};
std::optional<PositionsCompared> comparePositions(const Observation& now);
/// Compares the mirror image of the centres with the reference.
std::optional<PositionsCompared> compareMirroredPositions(const Observation& now);

/// [1] How far y rises with x, whatever the curve: the correlation of their ranks, equal values having the mean of
/// their ranks; −1 to 1 [Spearman 1904]. Neighbours in order that differ by at most 1e-9 of the largest count as equal:
/// rounding must not decide. Absent where all x or all y are equal. As many x as y. O(n log n)
std::optional<double> rankCorrelation(std::span<const double> x, std::span<const double> y);

}  // namespace morula
