#pragma once
// From a lineage to what a scenario needs. Lengths and times here are the scene's, if nothing else is said.
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/cell_path.h"
#include "tracks/tracks.h"
#include "values/cell_names.h"
#include "values/units.h"

namespace morula::tracks {

struct EmbryoOptions {
  Units units = {};  // names, and how many of them one length and one time of the table are
  std::optional<std::array<double, 3>> shell = {};  // semi-axes along x, y and z, as the table's lengths
  bool areSpheres = false;
  std::string root = {};                   // its descendants alone; "": all cells
  std::optional<double> perTime = {};      // of the table's times, one of the scene's; absent: by the lives of cells
  std::vector<std::string> settings = {};  // "physics.drag=5", which take precedence over what the table gives
  /// Headers, as TableOptions::columns.
  std::map<std::string, std::string> columns = {};
};

/// The cells between two births or deaths, and where they are in the middle.
struct Stage {
  int cells = 0;
  double begin = 0, end = 0;                       // the table's
  std::vector<std::pair<int, Point>> places = {};  // of those that the table has then
  std::vector<std::pair<int, int>> contacts = {};  // by places and volumes; none if one of these is not known
};

/// Returns true if the cell lives while the stage lasts. Times are the table's.
inline bool livesIn(const TrackedCell& cell, const Stage& stage) {
  return cell.birth <= stage.begin && !(cell.end <= stage.begin);
}

/// A division; absent: the table does not say.
struct Division {
  std::optional<Vector> axis;   // to daughter A, of length 1
  std::optional<double> share;  // of the volume, for A
};

struct Embryo {
  Lineage lineage;
  // By cell, as in lineage.cells
  std::vector<std::string> substance;
  std::vector<CellPath> path;
  std::vector<double> life;  // unsaid: it has no end
  std::vector<Division> division;

  double length = 1, time = 1;  // of the table's, one of the scene's
  double stop = 0;              // when the table ends, and half a frame
  bool areSpheres = false;
  double egg = 1;         // radius of the body of all cells together; less than 1 of balls in a shell
  bool hasBodies = true;  // false: the table has neither places nor axes
  Point centre;           // of the shell, as the table's places
  std::optional<std::array<double, 3>> shell;   // semi-axes, as the table's lengths; absent: a sphere about the egg
  double fill = 0.9;                            // the egg's share of the shell
  std::vector<std::pair<Point, double>> start;  // place and scale of each founder, if there are several
  CellNames names;
  std::vector<Stage> stages;         // rising by number of cells
  std::vector<std::string> assumed;  // sentences for people
};

Embryo makeEmbryo(Lineage lineage, const EmbryoOptions& options);

}  // namespace morula::tracks
