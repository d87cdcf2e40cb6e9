#pragma once
// The rows of each cell, put together.
#include <string>
#include <vector>

#include "tracks/tracks.h"

namespace morula::tracks {

/// The rows of one track.
struct Track {
  std::string id, name;
  std::string path = {};  // as the first row gives it
  int line = 0;           // the first in the file
  int mother = -1;
  std::vector<int> daughters;
  double birth = unsaid, last = unsaid, end = unsaid;  // last: when it is last seen; end: as a row per cell says
  bool dies = false;
  std::vector<Sighting> seen;  // by time
  int volumes = 0;             // that rows give
  double volumeSum = 0;
  Vector axis{unsaid, unsaid, unsaid};
};

/// The tracks in the order in which the table names them, each with its mother. `times`: receives the times of all
/// frames, rising; none of a row per cell. Rows that contradict each other are problems.
std::vector<Track> tracksOf(const CellTable& table, std::vector<double>& times, scenario::Problems& problems);

}  // namespace morula::tracks
