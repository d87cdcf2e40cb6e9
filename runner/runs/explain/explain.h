#pragma once
// Finds the step at which two runs of one scene part, and the kind of the first difference; and the first difference of
// two states, down to the vertex.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "explain/run_source.h"

namespace morula {

struct World;

struct StateDifference {
  bool lineage = false;             // who lives, what they are or when they were born; else physics
  std::optional<std::string> cell;  // path; "" is the egg; none: it is no cell's
  std::string field;                // "position", "substances", "clock.time step"
  std::optional<int> vertex;        // of the cell's mesh
  std::string component;            // "x", "y" or "z" of a vector
  std::string expected, actual;     // numbers in decimal, shortest
  std::string text;                 // for people, one line; numbers also in hexadecimal and ulps
};

/// The first difference in the order: living cells, their biology, connections and lineage, then the clock,
/// then each cell's parameters, positions, accelerations and velocities (as a step makes them, one from the
/// other) by lineage path and vertex. Bits count: 0 and −0 differ, and equal bits are equal even if they are
/// no number. None if all agrees.
std::optional<StateDifference> findStateDifference(const World& expected, const World& actual);

struct Explanation {
  std::string failureClass;                // "": the same bits; SETUP, LINEAGE, COMPUTATION; a caller may know better
  std::optional<std::uint64_t> step;       // the first step that differs; the last of the window if not narrowed
  std::optional<std::uint64_t> lastEqual;  // the last step known to be the same
  std::optional<std::string> cell;         // the first that differs
  std::vector<std::string> cells;          // all whose hashes differ at `step`
  std::optional<StateDifference> difference;  // absent where only the hashes of a run are known
  std::optional<Hash> expectedEnd;            // of the expected run's last state; absent if none is known
  std::string text;                           // for people, several lines
};

/// Follows both runs every `every` steps to where they first differ, then step by step through that window,
/// then compares the states. A difference that heals between two states looked at leaves no trace: with
/// `every` 1 none is missed.
Explanation explain(RunSource& expected, RunSource& actual, std::uint64_t every = 64);
/// Two runs of the scenario by this program, computed so and in another way (otherExecution).
Explanation explainTwice(const Scenario& scenario, const Execution& how, std::uint64_t every = 64);
/// Two runs of one program: whatever differs is NONDETERMINISM, a bug or broken hardware, and to be told first.
Explanation explainTwice(RunSource& first, RunSource& second, std::uint64_t every = 64);

}  // namespace morula
