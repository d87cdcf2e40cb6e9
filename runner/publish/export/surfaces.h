#pragma once
// The tree, samples and surfaces of one run, for the formats. Surfaces come from the database if the run kept them;
// otherwise the run is simulated again, with the same bits.
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "image/colour.h"
#include "simulation/simulation.h"
#include "store/store.h"
#include "values/units.h"

namespace morula {

enum class Wanted {
  tree,      // no samples
  measures,  // all samples, as the database has them, without surfaces
  samples,   // all samples, with surfaces if cells have bodies
  surfaces,  // only samples with surfaces
};

struct SurfaceRequest {
  Wanted wanted = Wanted::surfaces;
  std::optional<double> time;  // [time] the time of the only wanted sample
  bool atEnd = false;          // without a time: true: only the last sample; false: all
  Execution execution;         // for a run that is simulated again
  bool quiet = false;
};

struct ExportedRun {
  StoredRun run;
  RunResults results{};                 // lineage by path; samples as wanted
  std::map<StateId, Colour> colours{};  // the scenario's colours of substances
  std::map<CellPath, Colour> own{};     // the scenario's colours of cells, for those that have one
  std::vector<std::string> states{};    // the distinct texts of states, in their order
  std::set<std::string> givenNames{};   // those in results.names
  Units units{};                        // the scenario's
  bool hasBodies = true;                // false: there is a lineage alone

  /// Returns the colour of a cell in a state.
  Colour colourOf(const CellPath& cell, StateId state) const;
  /// Returns the index of a cell in results.lineage, or −1 if it never lived. O(log cells)
  int cellNumber(const CellPath& path) const;
  /// Returns a cell's name, or else its path, or "egg"; a path that is also another cell's name is preceded by '/'.
  std::string nameOf(const LineageEntry& cell) const;
  const MeshFaces& meshOf(const CellSurface& surface) const;
  /// Returns the measures of a cell in a sample; null if it has none.
  static const CellMeasures* measuresOf(const Sample& sample, const CellPath& path);
  /// Returns the index of a state's text in `states`.
  int stateNumber(StateId state) const;
};

/// Reads the run, and simulates it again if needed, which stderr tells. Throws UsageError for a run without bodies or
/// for a time outside of the run. Throws FileError for an unfinished run that would have to be simulated again, or one
/// that now ends differently.
ExportedRun exportedRun(Store& store, const StoredRun& run, const SurfaceRequest& request);

}  // namespace morula
