#pragma once
// Cells over time in the form of trackers, who follow cells in microscopy: a spot is a cell in one sample, a track all
// spots of one cell. Places, volumes and times are in the scenario's `units`, or in the scene's own without these.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "export/csv.h"
#include "export/surfaces.h"

namespace morula {

struct TrackedSpot {
  std::size_t track = 0;  // among Tracks::tracks
  double time = 0;
  Point place;                   // the cell's centroid
  std::optional<double> volume;  // absent: not measured
};

struct CellTrack {
  const LineageEntry* cell = nullptr;
  std::string name;             // or else the path, as csvPath gives it; "" if that is another cell's name
  std::vector<int> spots = {};  // by time, at least one
  int parent = -1;              // the track of the nearest ancestor with spots; -1: there is none
};

struct Tracks {
  std::vector<CellTrack> tracks;   // by path
  std::vector<TrackedSpot> spots;  // by time, then track
  Units units;

  const CellTrack& trackOf(const TrackedSpot& spot) const { return tracks[spot.track]; }
};

/// A number or text of each spot.
struct SpotField {
  const char *name, *meaning, *unit;                    // unit: "length³", of the scene
  TableValue (*of)(const Tracks&, const TrackedSpot&);  // a missing value: not measured
};
/// Returns the columns of a table of tracks: track_id, t, z, y, x, parent_track_id, name, path, volume and fate.
std::span<const SpotField> spotFields();

/// Makes the tracks of a run, which they refer to. Cells without a spot, which lived between two samples, are told on
/// stderr unless `quiet`. Throws UsageError if there are no spots.
Tracks tracksOf(const ExportedRun& run, bool quiet);

/// Returns a row for each spot, with the columns of spotFields, as `morula init --from` reads it.
CsvTable trackTable(const Tracks& tracks);

}  // namespace morula
