#pragma once
// A trial run of a run's beginning, to predict the rest. The genes alone tell how many cells live when; the first eras
// tell the steps, searches and contacts of later ones. Counts are the same on every machine.
#include <cstdint>
#include <vector>

#include "simulation/memory.h"
#include "simulation/simulation.h"

namespace morula {

/// A time without births and deaths.
struct Era {
  double from = 0, to = 0;  // [time]
  std::uint64_t cells = 1;  // living cells
  int generation = 0;       // divisions before the youngest cells, which are the lightest
};

struct Life {
  std::vector<Era> eras;         // without gaps; the last may have no length
  std::uint64_t cellsAsked = 0;  // cells asked in all cell cycles, which determines their cost
  std::uint64_t moments = 0;     // number of moments at which cell cycles ran
  std::uint64_t divisions = 0;
  bool whole = true;   // false: only the beginning, since there were too many cells to follow
  double seconds = 0;  // [s] CPU time of the cell cycles

  std::uint64_t maxCells() const;
};

/// Follows the genes, without bodies, to the scene's stop, or until cells have been asked `most` times. The result also
/// holds for a run with physics, while cells know nothing of their bodies.
Life predictLife(const Scene& scene, std::uint64_t most = 1'000'000);

/// The counts of an era of bodies.
struct EraCounts {
  double steps = 0, searches = 0;  // in a quasi-static scene: force evaluations
  double pairs = 0;                // evaluations of pairs of vertex and neighbour
};

struct TrialRun {
  World world;                  // state at the end of the trial run
  std::vector<EraCounts> eras;  // reached eras; the last may be incomplete
  bool whole = false;           // true: it reached the run's end
  double seconds = 0;           // [s] CPU time of all steps
  double lastEvaluations = 1;   // force evaluations in a quasi-static scene's last settling after a birth or death
  // CPU time [s] of the steps with births or deaths, and the sum of the cells living then
  double changeSeconds = 0;
  std::uint64_t changeCells = 0;
  // After the last birth or death: the max stable time step [time], and the divisions before the youngest cell
  double timeStepLimit = 0;
  int generation = 0;
};

/// Runs a new world for about `vertexSteps` steps times vertices. Throws NumericalError as a run would.
TrialRun tryBeginning(World world, const Life& life, double vertexSteps = 8e6);

/// Predicts the max stable time step [time] after so many divisions: that of an equal part of a free egg, reduced with
/// each division as the trial run found for real cells, which are uneven and pressed.
double predictTimeStepLimit(const TrialRun& trial, int generation);

/// Returns the mean number of vertices of the living cells, which may have different meshes; the egg's if none lives.
double verticesPerCell(const Bodies& bodies);

/// Predicts the counts of each era of a life with bodies.
std::vector<EraCounts> extrapolate(const Life& life, const TrialRun& trial);

/// Predicts memory at the largest number of cells; exact for a trial run that reached its end with them.
MemoryUse extrapolateMemory(const Life& life, const TrialRun& trial);

}  // namespace morula
