#pragma once
// What a scenario may say about one cell's mechanics. Units are the scene's own: a length, a mass and a time.
// Every field here changes results.
#include <cstdint>
#include <optional>

#include "base/precision.h"

namespace morula {

enum class Integrator {
  velocityVerlet,   // second order; the default
  thesisVerlet,     // as the thesis starts it: first order [Nilsson 2008, eq. 4.6, 4.7]
  explicitEuler,    // first order, and gains energy: stable only where drag takes it [Nilsson 2008, eq. 3.12]
  symplecticEuler,  // first order
  rungeKutta4,      // fourth order, four evaluations of the forces per step
  xpbd,             // first order, stable with any time step but for contacts
};

/// What keeps a cell in shape.
enum class CellModel {
  shell,          // a membrane of springs around contents under pressure [Nilsson 2008, §4.2]; the default
  shapeMatching,  // each vertex is drawn to its place in the shape at rest [Müller et al. 2005]; no pressure
  sphere,         // a point with a radius: a ball that keeps its shape
};

struct CellParameters {
  double radius = 1;  // [length] of the sphere whose volume the egg encloses at rest, whatever its mesh
  double mass = 1;    // [mass] of the egg, spread evenly over the vertices [Nilsson 2008, eq. 4.1]
  CellModel model = CellModel::shell;
};

/// Every mesh edge is a damped spring [Nilsson 2008, eq. 4.2].
struct MembraneParameters {
  double stiffness = 10;  // k_s [force/length]; higher: rounder cells, shorter steps
  double damping = 0.02;  // k_d [force·time/length] along the edge
  double production =
      1.26;  // membrane area of both daughters together over their mother's; 2^(1/3) keeps a sphere's tension
};

/// P = k_p/V − P_0 [Nilsson 2008, eq. 4.3].
struct PressureParameters {
  double constant =
      207;  // k_p [force·length], nRT of the egg; daughters share it by volume; higher: stiffer contents
  double outside = 48;  // P_0 [force/length²]; k_p/P_0 is the volume that the contents want: 3 % more than an
                        // egg of radius 1 has, so that its membrane is taut
};

/// a = −k (x − goal), with goals that move and turn with the cell (shape_kernel.h); instead of membrane and
/// pressure.
struct ShapeMatchingParameters {
  double stiffness = 400;  // k [1/time²]; a cell rings √k/2π times per time; higher: firmer, shorter steps
  double linear = 0;       // β, 0 to 1: how far goals follow linear deformations at the volume at rest
  double damping = 4;      // κ [1/time] of all motion but the cell's rigid one; 2√k is critical
};

/// How fast a cell grows or shrinks while its biology wants to.
struct GrowthParameters {
  double rate = 0.1;  // [1/time] relative change of k_p and mass; lengths follow with a third of it
};

struct ShellParameters {
  double semiAxes[3] = {1, 1, 1};  // [length]; all equal: a sphere
};

struct PhysicsParameters {
  std::optional<double> coarsen;   // [length] a daughter takes the coarsest of the scene's meshes whose mean
                                   // edge at rest is no longer; absent: every cell has the egg's mesh
  std::optional<double> timeStep;  // [time]; absent: auto, dyadic, from the stability limits
  double autoShare = 1;            // of the automatic time step, in (0, 1]; less: more exact and slower
  Integrator integrator = Integrator::velocityVerlet;
  std::optional<std::uint64_t> substeps;  // XPBD only: of a time step; more: more exact and slower; absent: 1
  Precision precision =
      Precision::binary64;  // of positions, velocities and forces; a cell's own numbers are doubles
  CellParameters cell;
  MembraneParameters membrane;
  PressureParameters pressure;
  ShapeMatchingParameters shapeMatching;
  double drag = 0;  // [1/time] acceleration −drag·v from the medium
  std::optional<GrowthParameters> growth;
  std::optional<ShellParameters> shell;
};

}  // namespace morula
