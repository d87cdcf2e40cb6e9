#pragma once
// A table of measured cells as a run is compared with it (morula run --against): places by stage, in the scene's units.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "observation/reference.h"
#include "values/cell_names.h"
#include "values/units.h"

namespace morula::tracks {

/// The cells of one stage. A stage with a number of cells is compared with the middle of the longest time in which the
/// run has so many.
struct MeasuredStage {
  int cells = 0;       // 0: the stage is at `time`
  double time = 0;     // [time]
  Reference measured;  // places [length], and contacts if the table lists some
};

struct MeasuredCells {
  std::vector<MeasuredStage> stages;  // rising by number of cells or by time
  std::vector<std::string> told;      // sentences for people: cells that the scenario does not know, columns not read
};

struct MeasuredOptions {
  std::optional<Units> units = {};  // the table's; absent: the scenario's; without names: the scene's own
  std::map<std::string, std::string> columns = {};  // TableOptions::columns
};

/// Reads a table, named `file` in messages: rows by cell and stage, or tracks, whose stages are those of which
/// `init --from` writes references. `scene`: the scenario's units. Throws InputError with all mistakes of the table,
/// each with its place, and for units of the table that are not the scenario's.
MeasuredCells readMeasured(std::string_view text, const std::string& file, const CellNames& names, const Units& scene,
                           const MeasuredOptions& options);

}  // namespace morula::tracks
