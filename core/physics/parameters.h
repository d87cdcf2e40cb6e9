#pragma once
// The parameters of one cell's mechanics, as a scenario gives them. Units are the scene's own: a length, a mass and a
// time. Every field here changes results.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "base/choice.h"
#include "base/members.h"
#include "base/precision.h"
#include "mesh/convex_shell.h"
#include "physics/damping.h"

namespace morula {

/// The method by which a scene advances in time. The properties of each integrator are in integrator.h.
enum class Integrator {
  velocityVerlet,
  thesisVerlet,
  explicitEuler,
  symplecticEuler,
  rungeKutta4,
  xpbd,
  quasiStatic
};
template <>
inline constexpr auto choices<Integrator> = std::to_array<Choice<Integrator>>({
    {Integrator::velocityVerlet, "velocity-verlet", "second order"},
    {Integrator::thesisVerlet, "thesis-verlet", "first order, as the thesis starts it [Nilsson 2008, eq. 4.6, 4.7]"},
    {Integrator::explicitEuler, "explicit-euler",
     "first order; gains energy, so it needs drag [Nilsson 2008, eq. 3.12]"},
    {Integrator::symplecticEuler, "symplectic-euler", "first order"},
    {Integrator::rungeKutta4, "rk4", "fourth order, with four evaluations of the forces per time step"},
    {Integrator::xpbd, "xpbd", "first order, and stable with any time step but for contacts"},
    {Integrator::quasiStatic, "quasi-static",
     "no motion through time: after each event cells settle, by a number of evaluations [Underwood 1983]"},
});

/// The model that keeps a cell in shape. The properties of each model are in cell_model.h.
enum class CellModel { shell, shapeMatching, sphere };
template <>
inline constexpr auto choices<CellModel> = std::to_array<Choice<CellModel>>({
    {CellModel::shell, "shell", "a membrane of springs around a fluid under pressure [Nilsson 2008, §4.2]"},
    {CellModel::shapeMatching, "shape-matching",
     "vertices drawn to the shape at rest [Müller et al. 2005]: cheaper, and knows no pressure"},
    {CellModel::sphere, "sphere", "a ball that keeps its shape: hundreds of times cheaper"},
});

struct CellParameters {
  double radius = 1;  // [length] of the sphere whose volume the egg encloses at rest, whatever its mesh
  double mass = 1;    // [mass] of the egg, spread evenly over the vertices [Nilsson 2008, eq. 4.1]
  CellModel model = CellModel::shell;
};
MORULA_MEMBERS(CellParameters, radius, mass, model)

/// The strength of each of a mesh's springs (makeSpringWeights).
enum class Springs { equal, dual };
template <>
inline constexpr auto choices<Springs> = std::to_array<Choice<Springs>>({
    {Springs::equal, "equal", "all alike [Nilsson 2008, eq. 4.2]: tauter where triangles are small or narrow"},
    {Springs::dual, "dual",
     "by dual over own length: the same tension everywhere and in all directions, and errors of second order "
     "in the mesh's edges"},
});

/// Every mesh edge is a damped spring [Nilsson 2008, eq. 4.2].
struct MembraneParameters {
  double stiffness = 10;  // k_s [force/length]; higher: rounder cells, shorter steps
  Damping damping;        // k_d along the edge
  // Membrane area of both daughters together over their mother's; 2^(1/3) keeps a sphere's tension.
  double areaFactor = 1.26;
  Springs springs = Springs::dual;  // factor of k_s and k_d of each edge
  double bending = 0;  // κ [force·length], Helfrich's rigidity (bending_kernel.h); higher: fewer folds; 0: none
};
MORULA_MEMBERS(MembraneParameters, stiffness, damping, areaFactor, springs, bending)

/// P = k_p/V − P_0 [Nilsson 2008, eq. 4.3].
struct PressureParameters {
  // k_p [force·length], nRT of the egg; daughters share it by volume; higher: a stiffer fluid
  double constant = 207;
  // P_0 [force/length²]; k_p/P_0 is the volume at which pressures balance: 3 % more than an egg of radius 1
  // has, so that its membrane is taut
  double outside = 48;
};
MORULA_MEMBERS(PressureParameters, constant, outside)

/// a = −k (x − goal), with goals that move and turn with the cell (shape_kernel.h); instead of membrane and pressure.
struct ShapeMatchingParameters {
  double stiffness = 400;  // k [1/time²]; a cell rings √k/2π times per time; higher: firmer, shorter steps
  double linear = 0;       // β, 0 to 1: how far goals follow linear deformations at the volume at rest
  double damping = 4;      // κ [1/time] of all motion but the cell's rigid one; 2√k is critical
};
MORULA_MEMBERS(ShapeMatchingParameters, stiffness, linear, damping)

/// The rate at which a cell grows or shrinks while its biology wants to.
struct GrowthParameters {
  double rate = 0.1;                 // [1/time] relative change of k_p and mass; lengths follow with a third of it
  std::optional<double> until = {};  // [1] volume at rest over the egg's at which growth stops; absent: it goes on
};
MORULA_MEMBERS(GrowthParameters, rate, until)

/// The part of a meshed cell that cannot leave a sphere or an ellipsoid.
enum class Held { vertices, surface };
template <>
inline constexpr auto choices<Held> = std::to_array<Choice<Held>>({
    {Held::vertices, "vertices",
     "the mesh's vertices: its faces lie deeper, so cells have less room than the shell encloses, and too "
     "high a pressure where they fill it"},
    {Held::surface, "surface",
     "the surface that holds the mesh's volume, below its vertices: room and pressure are right to third order in the "
     "mesh's edges"},
});

struct ShellParameters {
  std::array<double, 3> semiAxes = {1, 1, 1};    // [length]; all equal: a sphere
  std::shared_ptr<const ConvexShell> mesh = {};  // instead of the ellipsoid, if not null
  Held holds = Held::surface;                    // without effect in a mesh, and on balls
};
MORULA_MEMBERS(ShellParameters, semiAxes, mesh, holds)

/// Cells that crawl. An active force would move a cell alone through the medium at constant speed, and turns to a new
/// direction now and then, which the seed chooses.
struct MotilityParameters {
  double speed = 0.1;      // [length/time]; higher: cells change their neighbours more often
  double persistence = 1;  // [time] for which a cell keeps its direction
};
MORULA_MEMBERS(MotilityParameters, speed, persistence)

/// Quasi-static growth (Integrator::quasiStatic): how cells settle after each event (simulation/damped_motion.h).
struct QuasiStaticParameters {
  // [1] Evaluations of the forces in the shortest cell cycle, times √(vertices of a cell): waves cross a cell's mesh in
  // a number of evaluations in proportion to √vertices.
  double evaluations = 30;
  double drag = 5;                 // [1] drag on 128 cells, over the shortest cell cycle
  double together = 0;             // [time] events no farther apart share a settling
  std::optional<double> residual;  // [1] r [rest.h] to which the end of a run settles
};
MORULA_MEMBERS(QuasiStaticParameters, evaluations, drag, together, residual)

struct PhysicsParameters {
  // [length] A daughter takes the coarsest of the scene's meshes whose mean edge at rest is no longer; absent:
  // every cell has the egg's mesh.
  std::optional<double> coarsen;
  std::optional<double> timeStep;  // [time]; absent: auto, dyadic, from the stability limits
  double autoShare = 1;            // share of the automatic time step, in (0, 1]; less: more exact and slower
  Integrator integrator = Integrator::velocityVerlet;
  std::optional<std::uint64_t> substeps;      // XPBD only: per time step; more: more exact and slower; absent: 1
  Precision precision = Precision::binary64;  // of positions, velocities and forces; cells' own numbers are doubles
  CellParameters cell;
  MembraneParameters membrane;
  PressureParameters pressure;
  ShapeMatchingParameters shapeMatching;
  double drag = 0;  // [1/time] acceleration −drag·v from the medium
  std::optional<GrowthParameters> growth;
  std::optional<ShellParameters> shell;
  std::optional<MotilityParameters> motility;
  QuasiStaticParameters quasiStatic;  // with Integrator::quasiStatic
};
MORULA_MEMBERS(PhysicsParameters, coarsen, timeStep, autoShare, integrator, substeps, precision, cell, membrane,
               pressure, shapeMatching, drag, growth, shell, motility, quasiStatic)

}  // namespace morula
