#pragma once
// Finds the step at which two runs of one scene part, and the kind of the first difference. Also finds the first
// difference of two states, down to the vertex.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "explain/run_source.h"
#include "golden/check_result.h"

namespace morula {

struct World;

struct StateDifference {
  bool lineage = false;             // living cells, their biology or their births; else physics
  std::optional<std::string> cell;  // path; "" is the egg; absent: the field belongs to no cell
  std::string field;                // "position", "substances", "clock.time step"
  std::optional<int> vertex;        // index in the cell's mesh
  std::string component;            // "x", "y" or "z" of a vector
  std::string expected, actual;     // numbers in decimal, shortest
  std::string text;                 // for people, one line; numbers also in hexadecimal and ulps
};

/// Returns the first difference in this order: living cells, their biology, connections and lineage, then the clock;
/// then each cell's parameters, positions, accelerations and velocities, as a step makes them, by lineage path and
/// vertex. Bits count: 0 and −0 differ, and NaNs of equal bits are equal. Absent if the states agree.
std::optional<StateDifference> findStateDifference(const World& expected, const World& actual);

struct Explanation {
  FailureClass failureClass = FailureClass::none;  // none: equal bits; callers may know better
  std::optional<std::uint64_t> step;               // the first that differs; the last of the window if not narrowed
  std::optional<std::uint64_t> lastEqual;          // the last step known to be equal
  std::optional<std::string> cell;                 // the first cell that differs
  std::vector<std::string> cells;                  // all cells whose hashes differ at `step`
  std::optional<StateDifference> difference;       // absent if only a run's hashes are known
  std::optional<Hash> expectedEnd;                 // hash of the expected run's last state; absent if unknown
  std::string text;                                // for people, several lines
};

/// Compares both runs every `every` steps until they differ, then step by step through that window, then their states.
/// A difference that vanishes between two compared states is missed; with `every` 1 none is.
Explanation explain(RunSource& expected, RunSource& actual, std::uint64_t every = 64);
/// Compares two runs of the scenario by this program, with `how` and with another execution (otherExecution).
Explanation explainTwice(const Scenario& scenario, const Execution& how, std::uint64_t every = 64);
/// Compares two runs of one program. Any difference is NONDETERMINISM, a bug or broken hardware, and is reported first.
Explanation explainTwice(RunSource& first, RunSource& second, std::uint64_t every = 64);

}  // namespace morula
