#pragma once
// Contact of cells: which vertices may touch (neighbour_list.h), what a vertex's neighbours read of it
// (snapshot.h), and the forces (the laws' kernels).
#include <array>
#include <cstdint>
#include <span>

#include "base/aligned.h"
#include "base/cell_path.h"
#include "contacts/acting_pairs.h"
#include "contacts/adhesion.h"
#include "contacts/contact_areas.h"
#include "contacts/contacts_kernels.h"
#include "contacts/neighbour_list.h"
#include "contacts/parameters.h"
#include "physics/bodies.h"

namespace morula {

struct Contacts {
  // Constant
  ContactParameters parameters;
  const ContactKernels* kernels = nullptr;
  std::array<ContactKernels::TakeSnapshot, blockLanes> takeSnapshot{};  // [living cells of a block − 1]
  ContactKernels::AddForces addForces = nullptr;                        // of the scene's cell model and law
  double skinShare = 0;                                                 // [SearchSettings]

  // State between rebuilds; nothing of it is part of the result
  double lightestVertex = 0;                   // [mass] the smallest of all cells
  double damping = 0;                          // C [force·time/length] for this mass
  AlignedVector<double> radius;                // [slot] influence radius [length]
  AlignedVector<double> inverseRadiusSquared;  // [slot] [1/length²]
  AlignedVector<RowMemory> rows;               // rows of every vertex, and the far row
  AlignedVector<double> farthest;              // [block] largest squared displacement since the list was built
  AlignedVector<double> deepest;               // [block] B u of the pair law's deepest overlap (deepestHeld)
  struct Scratch {
    Reals force, turn;  // [vertex][xyz][lane] of one block's surface
  };
  std::vector<Scratch> scratch;   // one per thread; of the pair law
  std::vector<double> steepness;  // [slot] of measureSteepness
  NeighbourList list;
  bool listIsValid = false;
  ActingPairs acting;  // used by the pair law without adhesion
  Adhesion adhesion;   // used by scenes with ContactParameters::adhesion

  // Counters
  std::uint64_t rebuilds = 0;
  std::uint64_t pairEvaluations = 0;  // a vertex with one in its list: each pair counts from both sides
  std::uint64_t listsThinned = 0;     // lists of vertices that acting pairs were chosen from; no checkpoint keeps it
};

Contacts makeContacts(const ContactParameters& parameters, Isa isa, const SearchSettings& search = {},
                      Precision precision = Precision::binary64, CellModel model = CellModel::shell);

/// Must be called when the set of cells has changed: sets radii, makes room for rows and voids the list.
void resetContacts(Contacts& contacts, const Bodies& bodies);

/// Must be called when cells have grown: influence radii follow the rest lengths, and the list is void.
void setInfluenceRadii(Contacts& contacts, const Bodies& bodies);
/// Sets the influence radii to `radii`, [cell] [length].
void setInfluenceRadii(Contacts& contacts, const Bodies& bodies, std::span<const double> radii);

/// Takes one block's snapshot from the scratch that `advance` has just filled. `sinceLast` [time]: time since the last
/// snapshot, alike for all blocks. If right, it saves looking at pairs; any other value gives the same result.
void takeSnapshot(Contacts& contacts, const Bodies& bodies, const BlockView& block, int index, double sinceLast = 0);

/// Builds the list anew if a vertex has moved half the skin. Needs all snapshots.
void refreshList(Contacts& contacts, const Bodies& bodies, int threads);

/// Returns how stiff [1] the deepest overlap is over K, as the last forces found it; 1 for the thesis' law and spheres.
double measureHardening(const Contacts& contacts);
/// Returns the factor by which a pair is stiffer at an overlap B [pair_law_kernel.h].
double hardeningAt(double overlap);
/// Sets stiffness[slot] to how stiff, over K, the cell's pair is whose repulsion ends most steeply with the distance
/// [pair_law_kernel.h]. Uses the last snapshots; 0 before the first search.
void measureSteepness(const Contacts& contacts, const Bodies& bodies, int threads, std::vector<double>& stiffness);

/// Adds contact forces to one block's force. Needs all snapshots and a valid list.
void addContactForces(Contacts& contacts, Bodies& bodies, int block, double timeStep);

}  // namespace morula
