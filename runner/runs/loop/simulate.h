#pragma once
// A scenario run to its end: the world and the records that it leaves.
#include <string>
#include <vector>

#include "loop/observer.h"
#include "loop/scenario_run.h"
#include "simulation/simulation.h"
#include "store/recorded_tables.h"
#include "store/recorder.h"

namespace morula {

/// Records that went to a sink during the run, as far as a golden holds them: hashes, samples without cells, and the
/// tables as a golden has them.
struct KeptForGolden {
  RunResults records = {};
  RecordedTables tables = {};
  void add(const RunResults& records);
};

struct Simulation {
  World world;
  RunEnd end;          // done or failed
  RunResults results;  // lineage, samples, step hashes, …
  KeptForGolden kept = {};
};

struct RunOptions {
  std::string label = {};             // of the progress line; "": the scenario's name
  bool quiet = true;                  // no progress line is shown
  RecordOptions record = {};          // options of recording, beside lineage and names
  RecordSink sink = {};               // receives records during the run; without a sink they are kept in memory
  std::vector<Observer*> watch = {};  // further observers
};

/// Runs the scenario from its beginning to its end. InputErrors name its file. A NumericalError is not thrown but told
/// in `end.failure`, with the names of cells that have one. Throws Interrupted if a signal comes.
Simulation simulate(const Scenario& scenario, const Execution& how, RunOptions options = {});

/// Runs the scenario in a world that is made already.
Simulation simulate(const Scenario& scenario, World world, RunOptions options = {});

/// Throws NumericalError if the run failed because a resource ran out (Want): such an end says nothing about the scene.
void requireEnough(const RunEnd& end);

}  // namespace morula
