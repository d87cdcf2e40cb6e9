// Sizes a shell that is given as a shape, by the egg's radius and physics.shell.fill.
#include <numbers>

#include "base/maths.h"
#include "mesh/mesh_measures.h"
#include "physics/cell_model.h"
#include "scenario/loading.h"

namespace morula::scenario {
namespace {

constexpr double rounding = 1e-9;  // [1] a size that has been computed before is kept

/// Scales the axes to abc = r³ / fill, so that 4π/3 r³ is `fill` of 4π/3 abc.
void scaleShell(ShellParameters& shell, double radius, double fill) {
  double* axes = shell.semiAxes.data();
  const double r3 = radius * radius * radius;
  const double scale = cubeRoot(r3 / (fill * (axes[0] * axes[1] * axes[2])));
  if (scale > 1 - rounding && scale < 1 + rounding) return;
  for (int i = 0; i < 3; ++i) axes[i] *= scale;
}

/// Scales the mesh about the origin, to the sphere's volume over `fill`.
void scaleMesh(ShellParameters& shell, double radius, double fill) {
  const Mesh& mesh = shell.mesh->mesh;
  const double egg = 4 * std::numbers::pi / 3 * radius * radius * radius;
  const double scale = cubeRoot(egg / (fill * measureVolume(mesh.vertices, mesh.faces)));
  shell.mesh = std::make_shared<ConvexShell>(scaleConvexShell(*shell.mesh, scale));
}

}  // namespace

void fitShell(Scenario& scenario) {
  MechanicsScene& mechanics = *scenario.scene.mechanics;
  if (!scenario.shellFill || !mechanics.physics.shell) return;
  const double radius = mechanics.physics.cell.radius, fill = *scenario.shellFill;
  if (scenario.shellMesh) {
    if (mechanics.physics.shell->mesh) scaleMesh(*mechanics.physics.shell, radius, fill);
    return;
  }
  scaleShell(*mechanics.physics.shell, radius, fill);
  const double* axes = mechanics.physics.shell->semiAxes.data();
  const bool isRound = axes[0] == axes[1] && axes[1] == axes[2];
  if (isRound || !scenario.scene.cells.empty() || !kindOf(mechanics.physics.cell.model).hasMesh) return;
  // The egg gets the shell's shape, cbrt(fill) times as large: with abc·fill = r³ the product of its stretches is 1.
  const double share = cubeRoot(fill) / radius;
  StartCell egg;
  egg.stretch = {share * axes[0], share * axes[1], share * axes[2]};
  scenario.scene.cells = {egg};
  scenario.eggIsStretched = true;
}

}  // namespace morula::scenario
