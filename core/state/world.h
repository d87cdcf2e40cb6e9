#pragma once
// The state of a running scene. The functions that advance it are in simulation/simulation.h.
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/indirect.h"
#include "biology/biological_unit.h"
#include "biology/lineage.h"
#include "connections/connections.h"
#include "contacts/contact_search.h"
#include "division/division_record.h"
#include "division/policy.h"
#include "physics/bodies.h"
#include "physics/stages.h"
#include "state/experiment_record.h"
#include "state/scene.h"

namespace morula {

struct Contacts;  // contacts/contacts.h

/// Settings of the computation, which do not change a bit of the result.
struct Execution {
  Isa isa = bestIsa();
  int threads = 1;
  SearchSettings search = {};
  double memoryLimit = INFINITY;  // [byte] a run that needs more does not start, or ends as a failure
};

/// The living cells, by lineage path. The body of cell number i is stored in the slot Bodies::slots[i].
struct Cells {
  std::vector<CellPath> path;
  std::vector<StateId> state;
  std::vector<double> lastCycle;     // [time] when the cell's last cycle was due; its mother's before its first
  std::vector<double> growth;        // wantsToGrow, as it was at the last cell cycle
  std::vector<std::uint32_t> entry;  // index in lineage.entries
};

/// Returns the number of the living cell with this path; −1 if there is none. O(log cells)
int cellNumber(const Cells& cells, const CellPath& path);

struct Clock {
  double time = 0;         // [time] = epochTime + (step − epochStep)·timeStep, so no error piles up
  std::uint64_t step = 0;  // number of steps; in a lineage-only world, of moments when cell cycles ran
  double timeStep = 0;     // [time] 0 in a lineage-only or quasi-static world, which goes from cycle to cycle
  double epochTime = 0;    // [time] when the present time step came into force
  std::uint64_t epochStep = 0;
  double nextCycle = 0;  // [time] when the next cell cycle of any cell is due
};

/// The bodies before several steps at once, to be restored if these fail.
struct BodyCopy {
  Reals position, velocity, acceleration;
};

/// A change of the time step: one entry for the start and one for each change. Changes happen at divisions and deaths,
/// and at cell cycles where cells may grow or shrink.
struct TimeStepChange {
  double time = 0;
  std::uint64_t step = 0;
  double timeStep = 0;  // [time] from this step on
  friend bool operator==(const TimeStepChange&, const TimeStepChange&) = default;
};

/// The size of a living cell at its birth, kept if its division needs it (DivisionSize::Rule::adder).
struct BirthSize {
  double size = 0;  // [1] CellContext::sizeAtBirth
};

/// A settling of a quasi-static world (settle.h).
struct SettlingRecord {
  double time = 0;  // [time] of the events before the settling
  std::uint64_t step = 0, cells = 0;
  std::uint64_t evaluations = 0;  // evaluations of the forces
  double residual = 0;            // [1] r of rest.h, at the end of the settling
  std::optional<double> energyLeft = {};  // [force·length] energy of the motion left
  // [length] the farthest that a vertex goes on the way to QuasiStaticParameters::residual
  std::optional<double> displacementLeft = {};
};

/// The directions in which cells crawl, kept so that a steady step draws no numbers.
struct Motility {
  std::uint64_t interval = 0;     // number of the interval of persistence, counted from time 0
  std::vector<Vector> direction;  // [cell]
  bool isCurrent = false;         // direction fits the interval and the cells
};

/// A young cell about which the medium turns.
struct Swirl {
  int cell;         // its number among the living
  Vector axis;      // unit vector
  double rate;      // [1/time] ω at birth, in radians
  double time;      // [time] in which it falls to 1/e
  double born = 0;  // [time]
};

struct World {
  // Constant
  Scene model;
  Execution execution;
  std::unique_ptr<BiologicalUnit> biology;
  std::unique_ptr<DivisionPolicy> divisionPolicy;         // null without physics
  PhysicsStages stages{};                                 // in the instruction set of `execution`
  std::array<PhysicsStages, blockLanes> stagesOfLanes{};  // [living cells of a block − 1] in the set narrowestIsa

  // State
  Clock clock;
  Cells cells;
  std::optional<Bodies> bodies;            // absent: a lineage-only scene
  Indirect<Contacts> contacts;             // absent: cells cannot touch
  std::optional<Connections> connections;  // absent: nothing connects
  Lineage lineage;
  std::vector<TimeStepChange> timeSteps;
  std::vector<DivisionRecord> divisions;                     // of cells with bodies, in order of time and path
  std::optional<std::vector<BirthSize>> birthSizes;          // [cell]; absent: no division asks for them
  std::optional<std::vector<PolarityRecord>> polarities;     // by path; absent: no division plane keeps any
  std::optional<std::vector<SettlingRecord>> settlings;      // absent: the scene goes through time steps
  std::optional<std::vector<ExperimentRecord>> experiments;  // in the order in which they were done; absent: none

  std::optional<std::size_t> stoppedBy;      // the condition in StopParameters::when that holds; follows from the rest
  std::optional<BodyCopy> before;            // scratch of takeSteps
  std::optional<Motility> motility;          // for scenes with motility; follows from the rest
  std::optional<std::vector<Swirl>> swirls;  // follow from the divisions; absent: no rule has chirality
};

}  // namespace morula
