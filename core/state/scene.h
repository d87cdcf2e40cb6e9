#pragma once
// A scene: everything that decides what a run computes, and nothing else. An absent optional is an absent part of the
// World, and costs nothing. A scenario file is read into this struct (runner/input/scenario); makeWorld consumes it.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/members.h"
#include "biology/dna.h"
#include "biology/parameters.h"
#include "biology/variation.h"
#include "connections/parameters.h"
#include "contacts/parameters.h"
#include "division/parameters.h"
#include "mesh/mesh.h"
#include "physics/parameters.h"
#include "state/experiment.h"
#include "state/start_cell.h"
#include "state/stop_when.h"

namespace morula {

/// [longest cycle] Within this time, a run that only a number of cells ends must reach that number.
constexpr int maxCyclesForCells = 1000;

/// The limits of a run, which ends at the first one that is given; at least one is.
struct StopParameters {
  std::optional<std::uint64_t> cycles = {};  // times cycle.length: when cell cycle number `cycles` has run
  std::optional<double> time = {};           // [time]
  std::optional<std::uint64_t> cells = {};   // as soon as at least this many are alive
  std::vector<StopWhen> when = {};           // as soon as one of these holds
  std::optional<double> every = {};          // [time] between looks at `when`; absent: a twentieth of cycle.length
};
MORULA_MEMBERS(StopParameters, cycles, time, cells, when, every)

struct MechanicsScene {
  PhysicsParameters physics;
  Mesh mesh;                  // of the egg; encloses the volume of a sphere of physics.cell.radius
  std::vector<Mesh> coarser;  // meshes that daughters may take if physics.coarsen is given: see makeBodies
  std::optional<ContactParameters> contact;
  DivisionParameters division;
  std::optional<ConnectionParameters> connections;
};
MORULA_MEMBERS(MechanicsScene, physics, mesh, coarser, contact, division, connections)

struct Scene {
  std::string name;
  std::uint64_t seed = 0;
  Dna dna;
  CycleParameters cycle;
  StopParameters stop;
  std::optional<MechanicsScene> mechanics;  // absent: lineage only
  std::vector<StartCell> cells;             // cells that live at time 0; none: one egg at the origin
  VariationParameters variation;            // deviations that the seed decides
  std::vector<SenseParameters> senses;      // by substance, each once
  std::vector<Experiment> experiments;      // what is done to the organism while it grows
};
MORULA_MEMBERS(Scene, name, seed, dna, cycle, stop, mechanics, cells, variation, senses, experiments)

/// True if a part of the scene draws random numbers. Otherwise every seed gives the same result. Each part that comes
/// to draw numbers (grep for base/random.h) has its line in this function.
bool usesSeed(const Scene& scene);

/// Returns the simulated time [time] at which the run stops, if it is known beforehand (not with stop.cells or stop.when alone).
std::optional<double> plannedEnd(const Scene& scene);

}  // namespace morula
