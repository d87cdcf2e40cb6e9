#pragma once
// Measures one scene: its stages one by one on a fixed state, and whole steps on a state that moves on. Times are per
// vertex and step, in seconds.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "bench/ordinary_cell.h"
#include "bench/packed_world.h"
#include "contacts/contacts.h"
#include "system/clock.h"

namespace morula {

/// [edges] Root mean square movement of a vertex in one step. A dividing organism moves ten times as fast for a moment,
/// and slower for most of a cycle.
constexpr double stirredMove = 6e-4;
constexpr int stirEvery = 32;  // [steps]

/// The time of a whole step per vertex [s]: the mean over groups of steps without a search for neighbours, or the time
/// of a group with one if there are no others. The mean is taken since pairs are chosen in some steps only.
using StepTime = double;

/// Counters of a step, equal on every machine, instruction set and number of threads.
struct StepCounters {
  std::uint64_t steps = 0, rebuilds = 0, pairs = 0;  // pairs: entries of the lists
  std::uint64_t listsThinned = 0;                    // lists that acting pairs were chosen from
  std::uint64_t slots = 0, looks = 0;                // slots of the slices, summed over so many looks
};

/// Keeps a packed world moving, so that it is timed like a living organism. Gives every cell a random push, then scales
/// all velocities so that vertices move by `stirredMove` per step. The same step gets the same pushes in every call.
void stir(World& world);

/// Returns how many slots of slices forces go through: chosen pairs, and the far row where lists are shorter.
std::uint64_t countSlots(const Contacts& contacts);

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
  /// Returns the world's contacts before their first search.
  Contacts contactsToSearch(Isa isa, ContactSearch method) const;
  /// Returns the number of vertices that have neighbours in their list.
  double lists() const;
  /// Times one search for neighbours, due or not, without the choice of pairs that follows it.
  double timeRebuild(Isa isa, ContactSearch method, ClockKind clock = ClockKind::cpu, int threads = 1);
  /// Times one choice of pairs for all vertices, due or not, as the present state asks for.
  double timeChoice(Isa isa, ClockKind clock = ClockKind::cpu, int threads = 1);
  /// Times the inner forces in ordinary code.
  double timeOrdinaryForces();

  /// Times whole steps from the present state, which is restored.
  StepTime trySteps(Isa isa, int threads, ClockKind clock, int count);
  /// Times whole steps that move the state on, with regular stirring unless cells lie still, and adds to the counters.
  StepTime goOn(Isa isa, int count);
  const StepCounters& counters() const { return counters_; }

 private:
  struct State {
    Reals position, velocity, acceleration;
    AlignedVector<RowMemory> rows;
    AlignedVector<double> farthest;
    ActingPairs acting;
  };
  /// Returns empty contacts with the world's parameters.
  Contacts contactsWith(Isa isa, const SearchSettings& search) const;
  void useIsa(Isa isa, int threads);
  State keep() const;
  void restore(const State& state);
  /// Times a call for every block, per vertex [s], and restores the state.
  template <class Call>
  double timeBlocks(Isa isa, const Call& call);
  /// Times groups of steps. `each` is called after every step, `after` after every group with its number of steps.
  template <class Each, class After>
  StepTime timeSteps(ClockKind clock, int count, const Each& each, const After& after);

  World world_;
  bool stirred_;
  std::vector<OrdinaryCell> ordinary_;
  StepCounters counters_;
};

}  // namespace morula
