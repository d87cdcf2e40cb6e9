#pragma once
// The forces that act on the vertices of a cell.
#include <array>
#include <string>
#include <vector>

#include "base/choice.h"
#include "simulation/simulation.h"

namespace morula {

struct VertexForces {
  // The name: "springs", "contents", "outer pressure", "its shape", "contacts", "connections" or "crawling"
  std::string name;
  std::vector<Vector> onVertex;  // [force]
};

/// Returns the forces of the world's last evaluation on the cell in this slot, of those that the scene has. The world
/// is afterwards as before.
std::vector<VertexForces> measureForces(World& world, int slot);

/// Kinds of forces, for people.
enum class ForceKind { spring, pressure, contact, adhesion, shell, other };
template <>
inline constexpr auto choices<ForceKind> = std::to_array<Choice<ForceKind>>({
    {ForceKind::spring, "spring", "of the membrane"},
    {ForceKind::pressure, "pressure", "of the contents, less that of the medium"},
    {ForceKind::contact, "contact", "of cells that are pressed together, with viscosity"},
    {ForceKind::adhesion, "adhesion", "of cells that stick together, and of connections"},
    {ForceKind::shell, "shell", "of the shell against what presses on it"},
    {ForceKind::other, "other", "drag, crawling, chirality, and where a cell's shape is kept in another way that"},
});

/// The forces on the vertices of one cell, [ForceKind][vertex] [force]; all kinds add up to mass times acceleration.
using ForcesByKind = std::array<std::vector<Vector>, choices<ForceKind>.size()>;

/// Throws InputError for an integrator that solves for its forces, and so has none between two steps.
void checkHasForces(const PhysicsParameters& physics);

/// [cell] Evaluates forces at the world's positions and velocities. Requires bodies. Throws as checkHasForces.
std::vector<ForcesByKind> forcesByKind(World& world);

/// Measures forces without changing the world: they are evaluated in `scratch`, a world of the same scene, which has
/// this world's bodies afterwards.
std::vector<ForcesByKind> forcesByKind(const World& world, World& scratch);

}  // namespace morula
