#pragma once
// The pairs of the neighbour list that may act for a while: as long as surfaces turn, and stray from where their
// velocities bring them, by no more than a margin (acting_kernel.h). Single vertices that bounce use up their margin
// first; pairs are then chosen anew for these vertices alone. For the pair law without adhesion, slices are cut from
// chosen pairs alone, in a packed scene one pair in three. With adhesion all pairs within reach act.
#include <cstdint>
#include <vector>

#include "base/aligned.h"
#include "contacts/contacts_kernels.h"
#include "physics/bodies.h"

namespace morula {

struct Contacts;

/// The chosen pairs, and the time of their choice; no bit of the result depends on them.
struct ActingPairs {
  AlignedVector<float> change, speeds;  // [vertex] changes since its pairs were chosen (ChangeCount)
  // Since pairs of all vertices were chosen
  std::int64_t age = 0;      // [evaluation]
  double margin = 0;         // [length] by which gaps may change; infinite if all pairs were chosen
  double horizon = 0;        // [time] for which the choice may hold, since it looked ahead that far
  double largestRadius = 0;  // [length] influence radius
  int endedSoon = 0;         // choices in succession whose margins did not last
  struct OfBlock {
    double time = 0;                  // [time]
    std::vector<std::int32_t> ended;  // rows whose margin the last snapshot used up
    std::int32_t endedCount = 0;      // number of these rows
    std::int64_t endings = 0;         // ended choices of vertices
    double changed = 0;               // scratch: sum
  };
  std::vector<OfBlock> blocks;
  std::vector<std::uint8_t> marked;  // scratch: [vertex]
};

/// Returns true if slices are cut from chosen pairs only.
bool choosesPairs(const Contacts& contacts);

/// Prepares the count of changes in a snapshot of this block. `sinceLast` [time]: for which surfaces have moved by the
/// velocities of the last snapshot.
ChangeCount countChanges(Contacts& contacts, const Bodies& bodies, int block, double sinceLast);

/// Chooses among all pairs of the neighbour list anew, from all snapshots, and cuts the chosen ones into slices.
void choosePairs(Contacts& contacts, const Bodies& bodies, int threads);

/// Chooses anew among pairs of vertices whose choice has ended; among all pairs if these vertices are many.
void renewPairs(Contacts& contacts, const Bodies& bodies, int threads);

}  // namespace morula
