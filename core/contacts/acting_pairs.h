#pragma once
// The pairs of the neighbour list that may act before surfaces have moved and turned by a margin (acting_kernel.h). For
// the pair law without adhesion slices are cut of these alone: in a packed scene two pairs in five, and a step takes two
// thirds of its time. With adhesion all pairs within reach act.
#include <cstdint>

#include "base/aligned.h"
#include "contacts/contacts_kernels.h"
#include "physics/bodies.h"

namespace morula {

struct Contacts;

/// Which pairs were chosen, and since when; no bit of the result depends on it.
struct ActingPairs {
  AlignedVector<double> change;  // [block] by how much gaps may have changed since then [length]
  double margin = 0;             // [length] by how much they may; infinite if all pairs were
  double largestRadius = 0;      // [length] influence radius
  std::int64_t age = 0;          // in evaluations
};

/// Whether slices are cut of chosen pairs only.
bool choosesPairs(const Contacts& contacts);

/// Adds what a snapshot has changed in its block.
void countChange(Contacts& contacts, const SnapshotChange& change, int block);

/// Whether no other pairs than those chosen can act.
bool choiceHolds(const ActingPairs& acting);

/// Chooses pairs anew, from the neighbour list and all snapshots, and cuts them into slices.
void choosePairs(Contacts& contacts, const Bodies& bodies, int threads);

}  // namespace morula
