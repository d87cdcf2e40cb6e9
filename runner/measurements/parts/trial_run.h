#pragma once
// The beginning of a run, made to see what the rest will be like: how many cells live when, as the genes alone say, and
// how many steps, searches and contacts the first of them need; and from its eras to those that it did not come to.
// Counts are the same on every machine.
#include <cstdint>
#include <vector>

#include "simulation/memory.h"
#include "simulation/world.h"

namespace morula {

/// A time during which no cell is born and none dies.
struct Era {
  double from = 0, to = 0;  // [time]
  std::uint64_t cells = 1;  // alive
  int generation = 0;       // divisions before the youngest of them: they are the lightest
};

struct Life {
  std::vector<Era> eras;         // without gaps; the last may have no length
  std::uint64_t cellsAsked = 0;  // over all cell cycles: their cost is in proportion
  std::uint64_t moments = 0;     // at which cell cycles ran
  std::uint64_t divisions = 0;
  bool whole = true;   // false: only the beginning, for there are more cells than were to be followed
  double seconds = 0;  // [s] of CPU time that the cell cycles took

  std::uint64_t maxCells() const;
};

/// Follows the genes, without bodies, to the scene's stop, or until cells have been asked `most` times. While cells
/// know nothing of their bodies, it holds for a run with physics too.
Life predictLife(const Scene& scene, std::uint64_t most = 1'000'000);

/// The counts of an era of bodies.
struct EraCounts {
  double steps = 0, searches = 0;  // of a quasi-static scene: evaluations of the forces
  double pairs = 0;                // evaluations of a vertex and a neighbour
};

struct TrialRun {
  World world;                  // as it was left
  std::vector<EraCounts> eras;  // those that it came to; the last may be unfinished
  bool whole = false;           // it came to the run's end
  double seconds = 0;           // [s] of CPU time, all steps
  double lastEvaluations = 1;   // of a quasi-static scene's last settling after a birth or death
  // The steps among these in which cells were born or died, and the sum of cells that lived then.
  double changeSeconds = 0;
  std::uint64_t changeCells = 0;
  // After the last of them: up to which a time step was stable, at most [time], and the divisions before the youngest
  // cell.
  double timeStepLimit = 0;
  int generation = 0;
};

/// Runs the scene for about so many steps times vertices. `world` is new. Throws NumericalError as a run would.
TrialRun tryBeginning(World world, const Life& life, double vertexSteps = 8e6);

/// [time] Up to which a time step will be stable after so many divisions: for equal parts of a free egg, times what the
/// trial run has found real cells to lose against them with each division, being uneven and pressed.
double predictTimeStepLimit(const TrialRun& trial, int generation);

/// [vertices] Of a cell, in the mean over those that live: cells may have different meshes. Of the egg if none lives.
double verticesPerCell(const Bodies& bodies);

/// One for each era of a life with bodies.
std::vector<EraCounts> extrapolate(const Life& life, const TrialRun& trial);

/// At the largest number of cells. Exact for a trial run that came to its end with them.
MemoryUse extrapolateMemory(const Life& life, const TrialRun& trial);

}  // namespace morula
