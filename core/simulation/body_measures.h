#pragma once
// Measures of bodies as they are now. `slot`: Bodies::slots.
#include "biology/cell_context.h"
#include "biology/physical_unit.h"
#include "mesh/measures.h"
#include "physics/bodies.h"

namespace morula {

struct Contacts;

BodyShape measureShape(const Bodies& bodies, int slot);

/// [length³] Of one of the scene's meshes at rest, at rest scale 1; of a sphere the ball's.
double measureMeshVolume(const Bodies& bodies, int meshLevel);
/// [length³] PhysicalUnit::getRestVolume; `meshVolume`: measureMeshVolume of its mesh.
double measureRestVolume(const Bodies& bodies, int slot, double meshVolume);
double measureRestVolume(const Bodies& bodies, int slot);
/// Moments of the solid that the surface encloses; of a sphere those of the ball.
SolidMoments measureMoments(const Bodies& bodies, int slot);

/// [force·length] ½ Σ m v² over a cell's vertices.
double measureKineticEnergy(const Bodies& bodies, int slot);
/// [length/time] Of a cell's vertices.
Vector measureMeanVelocity(const Bodies& bodies, int slot);
/// [mass·length/time] Of all cells.
Vector measureMomentum(const Bodies& bodies);

/// [shell radii] How far out a cell reaches: 1 on the shell, which there must be. A sphere's is that of the
/// ball itself: the mesh that it is drawn with holds its volume, so that its vertices stand farther out. So do
/// those of a mesh in a shell that holds surfaces: what counts there is what it holds (physics/shell_surface.h).
double measureOutermost(const Bodies& bodies, int slot);
/// [length] The farthest that a vertex, or a ball's surface, or what a shell holds, is from the origin. NaN if a place
/// is no number.
double measureExtent(const Bodies& bodies);

/// [1] Share of a surface's area whose outer side is turned to the mean of its vertices.
double measureInvertedShare(const BodyShape& shape);

/// [1] The share of a surface that lies on the shell (where it holds surfaces: physics/shell_surface.h), to a millionth
/// of its size: a vertex there stands for a third of the area of its faces. 0 of a ball, which touches it in a point.
double measureShellShare(const BodyShape& shape, const ShellParameters& shell);

/// Returns a place relative to the shell: over its semi-axes, or over how far its mesh reaches along each axis.
ShellPlace measurePlaceInShell(const ShellParameters& shell, const Point& place);

/// [1] Mean over the cells of the share of a cell's volume that lies in another cell too, by the surfaces that contacts
/// (null: none) act on, and by scan lines through a grid of `columns` × `columns` columns; O(cells · faces).
double measureMeanOverlap(const Bodies& bodies, const Contacts* contacts, int columns = 256);

}  // namespace morula
