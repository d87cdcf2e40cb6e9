#pragma once
// Tables of tracked cells: CSV, TSV or blanks between fields, and man_track.txt of the Cell Tracking Challenge.
#include <deque>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/vec3.h"
#include "yaml/problems.h"

namespace morula::tracks {

inline constexpr double unsaid = std::numeric_limits<double>::quiet_NaN();

/// One row. A number that the table does not give is `unsaid`, a text is "". Texts are views into the table's text, or
/// into CellTable::unquoted.
struct Row {
  int line = 0;                         // in the file, from 1
  std::string_view cell, parent, name;  // cell: never ""
  std::string_view path;                // lineage path
  double time = unsaid;                 // of a row per frame
  double birth = unsaid, end = unsaid;  // of a row per cell
  Point place{unsaid, unsaid, unsaid};  // without a column z in the plane z = 0
  Vector axis{unsaid, unsaid, unsaid};  // of the cell's own division, towards daughter A
  double volume = unsaid;               // > 0
  bool dies = false;                    // at its end
  int stage = 0;                        // of a row per stage: its number of cells; 0: `time` is the stage
  std::string_view contacts{};          // of a row per stage: the cells that the cell touches
  /// A row per cell may give its places while so many cells live.
  std::vector<std::pair<int, Point>> placesAmong = {};
};

enum class Form {
  frames,    // a row per cell and frame
  cells,     // a row per cell, with times
  manTrack,  // a row per track: its first and last frame
  stages,    // a row per cell and stage, without parents
};

struct TableOptions {
  bool mayBeStages = false;                    // Form::stages is a form, too
  std::map<std::string, std::string> columns;  // headers by the names of columns, such as POSITION_X by x
};

struct CellTable {
  Form form = Form::frames;
  std::vector<Row> rows;
  bool isFlat = false;               // there are places in columns x and y, and no column z
  bool arePaths = false;             // Form::stages: Row::cell holds lineage paths
  std::vector<std::string> ignored;  // columns that are not read
  std::deque<std::string> unquoted;  // fields that had quotes in quotes
};

/// Returns true for words that R, pandas and Matlab write where nothing is known.
inline bool isUnknown(std::string_view field) { return field == "NA" || field == "NaN" || field == "nan"; }

/// Reads a table. Lines that begin with '#' are comments. A byte order mark is passed over. Mistakes are problems with
/// their places; reading ends after some twenty of them.
CellTable readCellTable(std::string_view text, scenario::Problems& problems, const TableOptions& options = {});

}  // namespace morula::tracks
