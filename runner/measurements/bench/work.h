#pragma once
// The work per vertex and step, counted from the formulas and not from code: the measure of a kernel. Operations are
// multiplications, additions, subtractions and comparisons (also min and max) of doubles, which go through the same
// ports; square roots and divisions count separately, as pairs. Bytes are those moved from or to memory, once per pass
// over all cells. All memory that a stage uses decides the cache that holds it. Instructions are counted in programs.
#include <array>

#include "base/choice.h"
#include "bench/machine_limits.h"
#include "physics/mesh_template.h"
#include "physics/parameters.h"

namespace morula {

struct Work {
  double operations = 0, roots = 0, bytes = 0;
  double touched = 0;       // [byte] memory used, per vertex
  double instructions = 0;  // 0: not counted
};

/// The instructions of stages, per vertex.
struct Instructions {
  double internal, integration, contact;  // contact: without what each slot takes
  double perSlot, perSlidingSlot;         // sliding: with viscosity
  double alone;                           // a step of cells that touch nothing, many at once
  double search, choice;                  // one for all vertices; a choice follows each search
};
/// Returns the instructions that gcc 12 makes for x86-64, counted in packed cells: AVX-512 by single steps, the others by
/// callgrind. tests/cost counts narrow and AVX2 again.
const Instructions& instructionsOf(Isa isa);

/// Returns the work of springs, volume and its gradient, pressure, drag.
Work internalWork(const MeshTemplate& mesh, const PhysicsParameters& physics);
/// Returns the springs' share of internalWork [1].
double springShare(const MeshTemplate& mesh, const PhysicsParameters& physics);
/// Returns the work of snapshots, pair forces, and their way from the surface to the vertices. `slots`: chosen pairs
/// that a vertex goes through, with the padding of slices.
Work contactWork(const MeshTemplate& mesh, double slots, bool viscosity);
/// Returns the work of drift, shell, kick.
Work integrationWork(bool shell);
/// Returns the work of a whole step: two passes over memory, or one without contact (null).
Work stepWork(const Work& internal, const Work* contact, const Work& integration);

/// The parts of a machine that work goes through.
enum class Bound { ports, divider, memory, frontEnd };
template <>
inline constexpr auto choices<Bound> = std::to_array<Choice<Bound>>({
    {Bound::ports, "ports", "operations, at the measured rate of multiplications and additions"},
    {Bound::divider, "divider", "roots with divisions, at their measured rate"},
    {Bound::memory, "memory", "bytes, at the bandwidth of the cache that holds the data"},
    {Bound::frontEnd, "front-end", "instructions, at the rate at which the machine takes in any"},
});

/// The least time per vertex and step [s] of each part of the machine, if all were busy at once.
struct WorkLimit {
  std::array<double, 4> seconds;  // [Bound]
  double of(Bound bound) const { return seconds[static_cast<std::size_t>(bound)]; }
  /// Returns the part that takes the longest.
  Bound bound() const;
};

/// Returns the machine's limits for this work. `vertices`: of all cells.
WorkLimit findLimit(const Work& work, const MachineLimits& limits, Isa isa, double vertices);

}  // namespace morula
