#pragma once
// The tree, samples and surfaces of one run, for the formats. Surfaces come from the database if the run kept them, or
// else from running it again, with the same bits.
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

  /// The place of a cell in results.lineage; −1: there never was one. O(log cells)
  int cellNumber(const CellPath& path) const;
  /// Returns the words for a cell: its name, or else its path, or "egg"; with a '/' before a path that is another
  /// cell's name.
  std::string nameOf(const LineageEntry& cell) const;
  const MeshFaces& meshOf(const CellSurface& surface) const;
  /// Returns the measures of a cell in a sample; null if it has none.
  static const CellMeasures* measuresOf(const Sample& sample, const CellPath& path);
  /// The place of a state's text in `states`.
  int stateNumber(StateId state) const;
};

/// Reads the run, and runs it again where it needs to, which stderr says. Throws UsageError for a run without bodies
/// and a time that it has not, FileError for a run that has not finished and would have to be made again, or that ends
/// otherwise now.
ExportedRun exportedRun(Store& store, const StoredRun& run, const SurfaceRequest& request);

}  // namespace morula
