#pragma once
// What the formats write of one run: its tree, samples and surfaces. Surfaces come from the database where the run kept
// them, and else from running it again: the same bits come out.
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "image/colour.h"
#include "simulation/world.h"
#include "store/store.h"

namespace morula {

enum class Wanted {
  tree,      // no samples
  samples,   // all, with the surfaces where cells have bodies
  surfaces,  // samples with surfaces alone
};

struct SurfaceRequest {
  Wanted wanted = Wanted::surfaces;
  std::optional<double> time;  // [time] of the one sample that is wanted
  bool atEnd = false;          // without a time: the last sample alone; false: all
  Execution execution;         // of a run that is made again
  bool quiet = false;
};

struct ExportedRun {
  StoredRun run;
  RunResults results;                 // lineage by path; samples as wanted
  std::map<StateId, Colour> colours;  // as the scenario has them
  std::vector<std::string> states;    // the distinct texts of states, in their order
  std::set<std::string> givenNames;   // those in results.names
  int signal = 0;                     // that interrupted it; then there is nothing to write

  /// The place of a cell in results.lineage; −1: there never was one. O(log cells)
  int cellNumber(const CellPath& path) const;
  /// What people call a cell: its name, or else its path, or "egg"; with a '/' before it where that is another one's name.
  std::string nameOf(const LineageEntry& cell) const;
  const MeshFaces& meshOf(const CellSurface& surface) const;
  /// What a sample measured of a cell; null if it did not.
  static const CellMeasures* measuresOf(const Sample& sample, const CellPath& path);
  /// The place of a state's text in `states`.
  int stateNumber(StateId state) const;
};

/// Reads the run, and runs it again where it needs to, which stderr says. Throws UsageError for a run without bodies and a
/// time that it has not, FileError for a run that has not finished and would have to be made again, or that ends otherwise
/// now.
ExportedRun exportedRun(Store& store, const StoredRun& run, const SurfaceRequest& request);

}  // namespace morula
