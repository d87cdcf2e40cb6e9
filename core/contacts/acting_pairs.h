#pragma once
// The pairs of the neighbour list that may act for a while: as long as surfaces turn, and stray from where their velocities
// bring them, by no more than a margin (acting_kernel.h). For the pair law without adhesion slices are cut of these alone:
// in a packed scene two pairs in five, and a step takes two thirds of its time. With adhesion all pairs within reach act.
#include <cstdint>
#include <span>
#include <vector>

#include "base/aligned.h"
#include "contacts/contacts_kernels.h"
#include "physics/bodies.h"

namespace morula {

struct Contacts;

/// Which pairs were chosen, and since when; no bit of the result depends on it.
struct ActingPairs {
  /// Since then, at most, of one cell.
  struct Change {
    double gaps = 0;    // [length] but for what velocities change
    double speeds = 0;  // [length/time] of velocities
    double drift = 0;   // [length] of gaps, by velocities that have changed
    double time = 0;    // [time]
  };
  std::vector<Change> change;        // [slot]
  std::vector<double> margin;        // [slot] by how much gaps may change [length]; infinite if all pairs were chosen
  AlignedVector<float> halfMargins;  // [vertex]
  double horizon = 0;                // [time] for which velocities of then were looked ahead, and the choice may hold
  double largestRadius = 0;          // [length] influence radius
  std::int64_t age = 0;              // in evaluations
  int endedSoon = 0;                 // choices in succession whose margins did not last
};

/// Whether slices are cut of chosen pairs only.
bool choosesPairs(const Contacts& contacts);

/// Adds what a snapshot has changed in its block. `sinceLast` [time]: ContactKernels::takeSnapshot.
void countChange(Contacts& contacts, const SnapshotChange& change, int block, double sinceLast);

/// Whether no other pairs than those chosen can act, of cells in these slots.
bool choiceHolds(const ActingPairs& acting, std::span<const int> slots);

/// Chooses pairs anew, from the neighbour list and all snapshots, and cuts them into slices.
void choosePairs(Contacts& contacts, const Bodies& bodies, int threads);

}  // namespace morula
