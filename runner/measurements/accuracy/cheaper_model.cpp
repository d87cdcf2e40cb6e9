// Cheaper cell models as substitutes for a scene's own.
#include "accuracy/trial.h"
#include "mesh/mesh_measures.h"
#include "physics/cell_model.h"
#include "physics/mesh_template.h"

namespace morula {

std::vector<CellModel> cheaperThan(CellModel model) {
  const CellModelKind& own = kindOf(model);
  std::vector<CellModel> cheaper;
  for (const CellModel other : valuesOf<CellModel>()) {
    const CellModelKind& kind = kindOf(other);
    const bool leavesOut = (own.hasMembrane && !kind.hasMembrane) || (own.hasMesh && !kind.hasMesh);
    if (leavesOut) cheaper.push_back(other);
  }
  return cheaper;
}

ShapeMatchingParameters matchShell(const PhysicsParameters& shell, const Mesh& egg) {
  double edges = 0, inertia = 0;
  const MeshTemplate mesh = makeTemplate(egg, shell.membrane.springs);
  for (int e = 0; e < mesh.edgeCount(); ++e) {
    const double weight = mesh.springWeights.empty() ? 1 : mesh.springWeights[e];
    edges += weight * mesh.restLengths[e] * mesh.restLengths[e];
  }
  for (const Point& x : egg.vertices) inertia += dot(x, x);
  inertia *= shell.cell.mass / static_cast<double>(egg.vertices.size());
  const double volume = measureVolume(egg.vertices, egg.faces);
  const double stretching = 0.4 * edges / inertia;
  const double breathing =
      (shell.membrane.stiffness * edges + 3 * shell.pressure.constant + 6 * shell.pressure.outside * volume) / inertia;
  const double damping = shell.membrane.damping.of(shell.membrane.stiffness,
                                                   shell.cell.mass / static_cast<double>(egg.vertices.size()));
  return {breathing, 1 - stretching * shell.membrane.stiffness / breathing, stretching * damping};
}

}  // namespace morula
