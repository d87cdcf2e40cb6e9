#pragma once
// Where two states of one scene part, down to the vertex.
#include <cstdint>
#include <optional>
#include <string>

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

}  // namespace morula
