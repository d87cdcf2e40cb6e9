// The measures of the whole organism. To add one: a row here; measures on demand stand last.
#include <algorithm>

#include "contacts/contacts.h"
#include "observation/body_measures.h"
#include "observation/crumpling.h"
#include "observation/energy.h"
#include "observation/measures.h"
#include "observation/organism_measures.h"
#include "physics/shell_surface.h"

namespace morula {
namespace {

using Value = std::optional<double>;
using Now = const Observation&;

const Bodies& bodiesOf(Now now) { return *now.world.bodies; }

/// Sums a quantity over all cells with a body.
template <class Get>
double sumOf(Now now, const Get& get) {
  double sum = 0;
  for (int slot : bodiesOf(now).slots) sum += get(bodiesOf(now), slot);
  return sum;
}
double volumeOf(const Bodies& b, int slot) { return b.volume[slot]; }
double pressureOf(const Bodies& b, int slot) { return b.pressure[slot]; }

/// Takes a measure of clones at the usual depth.
template <Value (*measure)(Now, int)>
Value ofClones(Now now) {
  return measure(now, cloneDepth);
}

// clang-format off
constexpr WorldMeasure ofWorld[] = {
    {.name = "cells", .meaning = "Number of living cells", .needs = Needs::nothing, .isWhole = true,
     .followsNumber = true, .get = [](Now now) -> Value { return double(now.world.cells.path.size()); }},
    {.name = "volume", .unit = "length³",
     .meaning = "Volume of all cells at the last evaluation of the forces [Nilsson 2008, eq. 4.4]",
     .get = [](Now now) -> Value { return sumOf(now, volumeOf); }},
    {.name = "kinetic_energy", .unit = "force·length",
     .meaning = "½ Σ m v² over the vertices of all cells",
     .followsNumber = true, .get = [](Now now) -> Value { return sumOf(now, measureKineticEnergy); }},
    {.name = "mean_pressure", .unit = "force/length²",
     .meaning = "Inner minus outer pressure [Nilsson 2008, eq. 4.3], in the mean over the cells; absent without cells",
     .get = [](Now now) -> Value {
       const int count = bodiesOf(now).count;
       return count > 0 ? Value(sumOf(now, pressureOf) / count) : Value();
     }},
    {.name = "shell_fill", .meaning = "Volume of all cells over the shell's", .needs = Needs::shell,
     .get = [](Now now) -> Value { return sumOf(now, volumeOf) / measureShellVolume(*bodiesOf(now).parameters.shell); }},
    {.name = "outermost", .unit = "shell radii",
     .meaning = "Max place of a vertex, or of a ball's surface, between the shell's middle, 0, and the shell, 1; "
                "absent without cells",
     .needs = Needs::shell,
     .get = [](Now now) -> Value {
       Value most;
       for (int slot : bodiesOf(now).slots) most = std::max(most.value_or(0), measureOutermost(bodiesOf(now), slot));
       return most;
     }},
    {.name = "extent", .unit = "length",
     .meaning = "Max distance of a vertex, or of a ball's surface, from the origin",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return measureExtent(bodiesOf(now)); }},
    {.name = "energy", .unit = "force·length",
     .meaning = "Sum of kinetic_energy, membrane_energy, contents_energy, connection_energy, contact_energy and "
                "adhesion_energy: constant but for the time step's error if nothing adds or takes energy",
     .taken = Taken::onDemand,
     .followsNumber = true, .get = [](Now now) -> Value { return measureEnergy(now.world).total(); }},
    {.name = "membrane_energy", .unit = "force·length",
     .meaning = "½ k_s (l − l₀)² of every edge, as strong as membrane.springs has it [Nilsson 2008, eq. 4.2], and the energy "
                "of membrane.bending",
     .taken = Taken::onDemand, .followsNumber = true, .get = [](Now now) -> Value { return measureEnergy(now.world).membrane; }},
    {.name = "contents_energy", .unit = "force·length",
     .meaning = "k_p (r − 1 − ln r) with r = P₀V/k_p, of every cell: 0 at rest [Nilsson 2008, eq. 4.3]",
     .taken = Taken::onDemand, .followsNumber = true, .get = [](Now now) -> Value { return measureEnergy(now.world).contents; }},
    {.name = "connection_energy", .unit = "force·length",
     .meaning = "k_c times the length of every connection [Nilsson 2008, eq. 4.9], or of a spring ½ k (d − rest)²",
     .taken = Taken::onDemand, .followsNumber = true, .get = [](Now now) -> Value { return measureEnergy(now.world).connections; }},
    {.name = "contact_energy", .unit = "force·length",
     .meaning = "Energy of overlaps: ½ s K D² u² (1 + 6B + 200B²) of every pair of vertices "
                "(core/contacts/pair_law_kernel.h); 0 with the thesis' law and for spheres, whose overlap energy is "
                "not computed",
     .needs = Needs::contact, .taken = Taken::onDemand,
     .followsNumber = true, .get = [](Now now) -> Value { return measureEnergy(now.world).contact; }},
    {.name = "adhesion_energy", .unit = "force·length",
     .meaning = "Energy of cells that stick, below 0: minus the work that parts them, −W per area of flat contact",
     .needs = Needs::contact, .taken = Taken::onDemand,
     .followsNumber = true, .get = [](Now now) -> Value { return measureEnergy(now.world).adhesion; }},
    {.name = "dissipated_power", .unit = "force·length/time",
     .meaning = "Power that drag, the membranes' damping, and the damping and viscosity of contacts take now; "
                "without the energy that the shell takes from cells that hit it",
     .taken = Taken::onDemand, .followsNumber = true, .get = [](Now now) -> Value { return measureDissipation(now.world); }},
    {.name = "momentum_x", .unit = "mass·length/time",
     .meaning = "Σ m v over the vertices of all cells, along x",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return measureMomentum(bodiesOf(now)).x; }},
    {.name = "momentum_y", .unit = "mass·length/time", .meaning = "Σ m v over the vertices of all cells, along y",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return measureMomentum(bodiesOf(now)).y; }},
    {.name = "momentum_z", .unit = "mass·length/time", .meaning = "Σ m v over the vertices of all cells, along z",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return measureMomentum(bodiesOf(now)).z; }},
    {.name = "mean_overlap",
     .meaning = "Share of a cell's volume that lies in another cell, too, by the surfaces that contacts act on, in "
                "the mean over the cells, by 256 × 256 scan lines",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return measureMeanOverlap(bodiesOf(now), now.world.contacts.get()); }},
    {.name = "folded_edges",
     .meaning = "Share of the edges of all cells' surfaces at which these fold over, as folded of a cell",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return sumOverCells(now, countFolded).share(); }},
    {.name = "compressed_edges",
     .meaning = "Share of the edges of all cells' membranes under compression, as compressed of a cell",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value { return sumOverCells(now, countCompressed).share(); }},
    {.name = "organism_elongation",
     .meaning = "Largest over second largest extent of the vertices of all cells together, as elongation of a cell",
     .taken = Taken::onDemand,
     .get = [](Now now) { return measureOrganismElongation(now); }},
    {.name = "sister_contact", .meaning = "Share of the living pairs of sisters that touch; absent without a pair",
     .needs = Needs::contact, .taken = Taken::onDemand,
     .get = [](Now now) { return measureRelativesInContact(now, 1); }},
    {.name = "cousin_contact",
     .meaning = "Share of the living pairs of cousins that touch: cells with one grandmother and two mothers, at "
                "the same depth; absent without a pair",
     .needs = Needs::contact, .taken = Taken::onDemand,
     .get = [](Now now) { return measureRelativesInContact(now, 2); }},
    {.name = "clone_contact",
     .meaning = "Share of the contact area between cells of clones that is within one; clones are the descendants of each "
                "cell two divisions from the egg; absent where none touch",
     .needs = Needs::contact, .taken = Taken::onDemand,
     .followsNumber = true, .get = ofClones<measureCloneContact>, .ofClones = measureCloneContact},
    {.name = "homotypic_contact",
     .meaning = "Share of the contact area that is between cells with the same substances; absent where none touch",
     .needs = Needs::contact, .taken = Taken::onDemand,
     .followsNumber = true, .get = [](Now now) { return measureHomotypicContact(now); }},
    {.name = "clone_radius", .unit = "length",
     .meaning = "Root mean square distance of the centres of a clone's cells from their mean, in the mean over the clones "
                "with two living cells at least",
     .taken = Taken::onDemand,
     .followsNumber = true, .get = ofClones<measureCloneRadius>, .ofClones = measureCloneRadius},
    {.name = "clone_spread",
     .meaning = "Root mean square distance of a clone's volume from its centre over that of a ball with this volume, √(3/5) R, in "
                "the mean over the clones that live: 1 for a ball, however many cells it is divided into, √(1 + 5/3 (d/2R)²)/∛2 "
                "for two balls of radius R, d apart",
     .taken = Taken::onDemand, .get = ofClones<measureCloneSpread>, .ofClones = measureCloneSpread},
    {.name = "clone_components",
     .meaning = "Connected pieces of a clone by its contacts, in the mean over the clones that live: 1 if none is torn",
     .needs = Needs::contact, .taken = Taken::onDemand,
     .followsNumber = true, .get = ofClones<measureClonePieces>, .ofClones = measureClonePieces},
    {.name = "mixing_index",
     .meaning = "Number of contacts that join different clones over the number expected if cells were dealt out at "
                "random: 0 apart, 1 mixed; a join count [Cliff, Ord 1981]",
     .needs = Needs::contact, .taken = Taken::onDemand,
     .followsNumber = true, .get = ofClones<measureMixing>, .ofClones = measureMixing},
    {.name = "lumen",
     .meaning = "Empty space that cells enclose over the sum of their volume and this space: the space covered by "
                "balls of half the radius of a mean cell that fit between cells and cannot get out, on a grid "
                "[mesh/cavities.h]; the gap to a shell is outside. The grid has cubes of edge h, 1/16 of the ball's "
                "radius or as long as 2 million cubes need; max error √3/2 h times the pockets' surface. Absent "
                "with more than some 60 000 cells",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value {
       const auto lumen = measureLumen(now);
       return lumen ? Value(lumen->all) : Value();
     }},
    {.name = "largest_lumen", .meaning = "Empty space of the largest connected pocket alone, as a share like lumen",
     .taken = Taken::onDemand,
     .get = [](Now now) -> Value {
       const auto lumen = measureLumen(now);
       return lumen ? Value(lumen->largest) : Value();
     }},
    {.name = "lineage_space",
     .meaning = "Rank correlation [Spearman 1904] over all pairs of cells of the divisions on the way from one to the other "
                "in the tree with the distance of their centres: 1 if relatives lie close",
     .taken = Taken::onDemand,
     .followsNumber = true, .get = [](Now now) { return measureLineageInSpace(now); }},
    {.name = "contact_jaccard",
     .meaning = "Contacts among living cells of check.reference.contacts that are there, too, over all that are here or "
                "there [Jaccard 1901]; absent where there are none",
     .needs = Needs::referenceContacts, .taken = Taken::onDemand,
     .get = [](Now now) -> Value {
       const ContactsCompared c = compareContacts(now);
       const double any = c.here + c.there - c.both;
       return any > 0 ? Value(c.both / any) : Value();
     }},
    {.name = "contact_f1", .meaning = "Agreement of contacts with check.reference.contacts, 2·both / (here + "
                                      "there): the harmonic mean of precision and recall [Dice 1945]",
     .needs = Needs::referenceContacts, .taken = Taken::onDemand,
     .get = [](Now now) -> Value {
       const ContactsCompared c = compareContacts(now);
       return c.here + c.there > 0 ? Value(2 * c.both / (c.here + c.there)) : Value();
     }},
    {.name = "position_rmsd", .unit = "length",
     .meaning = "Root mean square distance of the cells' centres from check.reference.positions, turned and moved to where "
                "it is least [Kabsch 1976], of the living cells that are there; absent with fewer than 3",
     .needs = Needs::referencePositions, .taken = Taken::onDemand,
     .get = [](Now now) -> Value {
       const auto compared = comparePositions(now);
       return compared ? Value(compared->distance) : Value();
     }},
    {.name = "position_shape_rmsd",
     .meaning = "Distance of the shapes alone: position_rmsd with the best scale, too, over the root mean square "
                "radius of the reference, in whatever unit the reference is given",
     .needs = Needs::referencePositions, .taken = Taken::onDemand,
     .get = [](Now now) -> Value {
       const auto compared = comparePositions(now);
       return compared ? Value(compared->shape) : Value();
     }},
};
// clang-format on

}  // namespace

template <>
std::span<const WorldMeasure> measures<Observation>() {
  return ofWorld;
}

}  // namespace morula
