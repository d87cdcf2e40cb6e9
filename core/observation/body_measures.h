#pragma once
// Measures of bodies in their present state. `slot`: Bodies::slots.
#include "biology/cell_context.h"
#include "biology/physical_unit.h"
#include "mesh/mesh_measures.h"
#include "physics/bodies.h"

namespace morula {

struct Contacts;

BodyShape measureShape(const Bodies& bodies, int slot);

/// Returns the volume [length³] of one of the scene's meshes at rest, at rest scale 1; for a sphere the ball's.
double measureMeshVolume(const Bodies& bodies, int meshLevel);
/// Returns PhysicalUnit::getRestVolume [length³] of a cell. `meshVolume`: measureMeshVolume of the cell's mesh.
double measureRestVolume(const Bodies& bodies, int slot, double meshVolume);
double measureRestVolume(const Bodies& bodies, int slot);
/// Returns the moments of the solid that the surface encloses; for a sphere those of the ball.
SolidMoments measureMoments(const Bodies& bodies, int slot);

/// Returns ½ Σ m v² [force·length] over a cell's vertices.
double measureKineticEnergy(const Bodies& bodies, int slot);
/// Returns the mean velocity [length/time] of a cell's vertices.
Vector measureMeanVelocity(const Bodies& bodies, int slot);
/// Returns the momentum [mass·length/time] of all cells.
Vector measureMomentum(const Bodies& bodies);

/// Returns how far out a cell reaches [shell radii]: 1 on the shell, which must exist. A sphere reaches as far as its
/// ball: the mesh that draws it holds the ball's volume, so its vertices stand farther out. In a shell that holds
/// surfaces a mesh's vertices do, too, and the held points count (physics/shell_surface.h).
double measureOutermost(const Bodies& bodies, int slot);
/// Returns the largest distance [length] of a vertex, of a ball's surface, or of a point that a shell holds, from the
/// origin. NaN if a coordinate is NaN.
double measureExtent(const Bodies& bodies);

/// Returns the share [1] of a surface's area whose outer side is turned to the mean of its vertices.
double measureInvertedShare(const BodyShape& shape);

/// Returns the share [1] of a surface that lies on the shell (if it holds surfaces: physics/shell_surface.h), to a
/// millionth of its size: a vertex there stands for a third of the area of its faces. 0 for a ball.
double measureShellShare(const BodyShape& shape, const ShellParameters& shell);

/// Returns a place relative to the shell: over its semi-axes, or over how far its mesh reaches along each axis.
ShellPlace measurePlaceInShell(const ShellParameters& shell, const Point& place);

/// Returns the mean over the cells of the share [1] of a cell's volume that lies in another cell too. Uses the surfaces
/// that contacts (null: none) act on, and scan lines through a grid of `columns` × `columns` columns; O(cells · faces).
double measureMeanOverlap(const Bodies& bodies, const Contacts* contacts, int columns = 256);

}  // namespace morula
