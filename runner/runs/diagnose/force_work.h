#pragma once
// Which force moves a cell.
#include <string>
#include <vector>

#include "diagnose/vertex_forces.h"
#include "simulation/world.h"

namespace morula {

struct ForceWork {
  // "springs", "contents", "outer pressure", "its shape", "contacts", "connections" or "crawling"
  std::string force;
  double work = 0;  // [force·length] on the cell's vertices; negative: it resisted
};

/// Sums up, step by step, the work Σ f·Δx of each force on the vertices of one cell: f the mean of the forces
/// at both ends of the step.
class WorkMeter {
 public:
  /// The cell must live in the world and go on living.
  WorkMeter(World& world, const CellPath& cell);
  /// To be called after each step; the forces that it measures come from the world's last evaluation.
  void observe(World& world);

  /// Largest first; only forces that the scene has.
  std::vector<ForceWork> works() const;

 private:
  std::vector<Point> positions(const World& world) const;
  int slotIn(const World& world) const;

  CellPath cell_;
  std::vector<Point> before_;
  std::vector<VertexForces> forces_;
  std::vector<ForceWork> works_;
};

}  // namespace morula
