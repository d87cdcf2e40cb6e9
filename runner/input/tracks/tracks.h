#pragma once
// From rows to a lineage: who descends from whom, when, where and of what volume.
#include <string>
#include <vector>

#include "tracks/cell_table.h"

namespace morula::tracks {

/// The place of a cell at a time of the table.
struct Sighting {
  double time;  // of a row per cell: the number of cells that live then; 0: it says nothing of that
  Point place;
  int line;  // in the file
};

/// A cell from birth to end. Times, lengths and volumes are the table's.
struct TrackedCell {
  std::string id, name;  // the name is the id where the table gives none
  int line = 0;          // the first in the file
  int mother = -1;
  std::vector<int> daughters;  // none, or A and B
  double birth = unsaid;       // of a founder: when the table begins
  double end = unsaid;         // of its division or death; unsaid: it lives on
  bool dies = false;           // at its end
  std::vector<Sighting> seen;  // by time
  double volume = unsaid;      // the mean of those given
  Vector axis{unsaid, unsaid, unsaid};

  bool hasEnd() const { return end == end; }
};

struct Lineage {
  Form form = Form::frames;
  std::vector<TrackedCell> cells;  // by generation: the founders, their daughters A and B, …
  int founders = 0;
  double begin = 0, end = 0;         // when the table begins and ends
  double frame = 0;                  // the shortest time between two frames; 0 of a row per cell
  std::vector<std::string> assumed;  // sentences for people
};

/// Makes a lineage of a table; with `root` of the cell of that name or id and its descendants alone. What no lineage
/// can have is a problem with the row's place.
Lineage makeLineage(const CellTable& table, const std::string& root, scenario::Problems& problems);

}  // namespace morula::tracks
