#pragma once
// The forces on the cells of a frame, by kind, and their bytes in a page.
#include <string>
#include <vector>

#include "diagnose/vertex_forces.h"

namespace morula {

/// Measures the forces in a running world on a twin that it brings to the same state, so that the run is not touched.
class ForceMeter {
 public:
  /// `twin`: made of the same scene. There are no kinds where it has no bodies, or where its integrator solves for forces and
  /// knows none between two steps.
  explicit ForceMeter(World twin);

  /// Those that the scene can have; on a cell all others are none.
  const std::vector<ForceKind>& kinds() const { return kinds_; }
  /// [cell] Forces in a state of the scene; empty where they cannot be evaluated, or there are no kinds.
  std::vector<ForcesByKind> at(const World& world);

 private:
  World twin_;
  std::vector<ForceKind> kinds_;
};

/// The sum over a cell's vertices. [force]
Vector netForce(const ForcesByKind& cell, ForceKind kind);

/// Those of the kinds that may add up to anything: a closed cell's springs and contents do not.
std::vector<ForceKind> kindsWithNetForce(const std::vector<ForceKind>& kinds);

/// Of each cell and each of these kinds: float32 x, y, z of the net force [force]; NaN where `forces` is empty.
void putNetForces(std::string& bytes, const std::vector<ForcesByKind>& forces, std::size_t cells,
                  const std::vector<ForceKind>& kinds);

/// Of each cell and each of the kinds: float32 step [force]; then, again of each, where its step is not 0, int8 x, y, z for each
/// vertex: the force is step · number, and off by half a step at most. A step is the largest component over 127.
/// Where forces are rounding alone, less than 1e-9 of the greatest on the cell, the step is 0.
void putVertexForces(std::string& bytes, const std::vector<ForcesByKind>& forces, const std::vector<ForceKind>& kinds);

}  // namespace morula
