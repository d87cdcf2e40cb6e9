#pragma once
// One scene under measurement: its stages one by one on a state that stands still, and whole steps on one
// that goes on. Times are per vertex and step, in seconds.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "bench/ordinary_cell.h"
#include "bench/packed_world.h"
#include "contacts/contacts.h"
#include "system/clock.h"

namespace morula {

/// [edges] Root mean square way of a vertex in one step. An organism that divides moves ten times as fast for
/// a moment and slower for most of a cycle.
constexpr double stirredMove = 6e-4;
constexpr int stirEvery = 32;  // [steps]

/// [s] per vertex: what a whole step took in the mean over groups of steps in which no search for neighbours fell; of
/// one in which one fell, if there are no others. The mean, since pairs are chosen in some steps only.
using StepTime = double;

/// Counters of a step, equal on every machine, instruction set and number of threads.
struct StepCounters {
  std::uint64_t steps = 0, rebuilds = 0, pairs = 0;  // pairs: entries of the lists that were gone through
};

/// Keeps a packed world moving, so that it is timed as a living organism and not as a still life.
/// Gives every cell a push of its own in a random direction, then scales all velocities so that vertices move
/// by `stirredMove` per step. The same pushes for the same step in every call.
void stir(World& world);

class Subject {
 public:
  Subject(const PackedScene& packed, int maxThreads, const std::filesystem::path& folder,
          const std::function<void(const std::string&)>& tell);

  const World& world() const { return world_; }
  double vertices() const { return double(world_.bodies->count) * world_.bodies->vertexCount(); }
  bool touching() const { return world_.contacts.has_value(); }

  double timeInternal(Isa isa);
  double timeIntegration(Isa isa);
  double timeContact(Isa isa);
  /// The world's contacts before their first search.
  Contacts contactsToSearch(Isa isa, ContactSearch method) const;
  /// One search for neighbours, whether due or not.
  double timeRebuild(Isa isa, ContactSearch method, ClockKind clock = ClockKind::cpu, int threads = 1);
  /// The inner forces as ordinary code computes them.
  double timeOrdinaryForces();

  /// Whole steps from the present state, which stays.
  StepTime trySteps(Isa isa, int threads, ClockKind clock, int count);
  /// Whole steps that move the state on, stirred now and then; they count.
  StepTime goOn(Isa isa, int count);
  const StepCounters& counters() const { return counters_; }

 private:
  struct State {
    Reals position, velocity, acceleration;
    AlignedVector<RowMemory> rows;
    AlignedVector<double> farthest;
  };
  /// Returns contacts with the world's parameters, but empty.
  Contacts contactsWith(Isa isa, const SearchSettings& search) const;
  void useIsa(Isa isa, int threads);
  State keep() const;
  void restore(const State& state);
  /// [s] per vertex of a call for every block, on a state that stays.
  template <class Call>
  double timeBlocks(Isa isa, const Call& call);
  /// Times groups of steps, with `each` after every step; `after` is called after every group, with how many there
  /// were.
  template <class Each, class After>
  StepTime timeSteps(ClockKind clock, int count, const Each& each, const After& after);

  World world_;
  std::vector<OrdinaryCell> ordinary_;
  StepCounters counters_;
};

}  // namespace morula
