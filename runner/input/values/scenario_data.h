#pragma once
// A scenario that has been read and checked: what to compute (the Scene), what to record and check of it, and how to
// show it.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/hash.h"
#include "simulation/reference.h"
#include "simulation/scene.h"
#include "values/baseline.h"
#include "values/cell_names.h"
#include "values/units.h"

namespace morula {

/// The source of the egg's mesh: exactly one of the two is given.
struct EggMesh {
  std::optional<std::uint64_t> icosphere = 2;  // level 0 to 4: 12, 42, 162, 642, 2562 vertices
  std::optional<std::string> file;             // a Wavefront OBJ, relative to the scenario file
};

/// The parameters of recording. Nothing here changes what the cells do.
struct RecordParameters {
  std::optional<double> every;         // [time] between samples; absent: only the start and the end
  std::optional<double> pictures;      // [time] between pictures of a sequence; absent: only the end is drawn
  std::vector<std::uint64_t> atCells;  // rising; also when first so many cells live
  std::vector<std::string> measures;   // on demand [simulation/measures.h], at every sample
  std::optional<double> meshes;        // [time] between surfaces in the database; absent: none are kept
};

struct Bounds {
  double least = 0, most = 0;
};

/// The comparison with the same scene in Bullet, and how far apart the two may be at the end. Without any tolerance,
/// tolerances that fit the scene hold (engines/bullet_check.h).
struct BulletCheck {
  Baseline baseline = Baseline::b1;  // or b3; b2's springs rest at another length
  double margin = 0.01;              // [radii of the egg] of each surface in Bullet: what touches is two of them apart
  std::optional<double> positions;   // [length] of the vertex farthest off
  std::optional<double> radius;      // [1] of each cell: the mean distance of its vertices from their centre
  std::optional<double> volume;      // [1] of each cell
  std::optional<double> distance;    // [1] of the centres of cells that touch, less Bullet's gap
  // [1] of each cell: its length over its thickness, of the ellipsoid with its moments
  std::optional<double> aspect;

  bool hasTolerances() const { return positions || radius || volume || distance || aspect; }
};

/// Conditions on a run besides its golden. Nothing here changes what the cells do; absent conditions are not checked.
struct CheckParameters {
  // At every step, of every cell
  std::optional<Bounds> volume;    // [1] over the volume at rest: the egg's mesh with the cell's rest lengths
  std::optional<double> extent;    // [length] of the vertex farthest from the origin
  std::optional<double> energy;    // [force·length] kinetic and elastic, of all cells
  std::optional<double> momentum;  // [mass·length/time] how far the sum of all may stray from the start's
  // At the end
  std::optional<Bounds> endVolume;     // [1] as volume
  std::optional<double> endRoundness;  // [1] the least sphericity of a cell
  std::optional<double> endOverlap;    // [1] mean share of a cell's volume that lies in another too
  std::vector<std::string> fails;      // the run must stop, and all of these stand in the reason; or none
  bool sane = true;                    // false: the scene is about an end that is not (core/simulation/sanity.h)
  std::string because;                 // why it is not; "" if it is
  std::optional<BulletCheck> bullet;   // held against Bullet
  std::optional<Reference> reference;  // what some measures compare the organism with
};

/// A file that a scenario names.
struct NamedFile {
  std::string role;  // "dna", "mesh", "shell", "names" or "reference"
  std::string path;  // where it was read from
  std::string content;
};

struct Scenario {
  std::uint64_t format = 1;
  std::string summary;
  Scene scene;  // ready for makeWorld: DNA parsed, mesh built and scaled
  EggMesh mesh;
  /// '#rrggbb' in lower case by substance. A name that ends in '*' stands for every substance that begins so.
  std::map<std::string, std::string> colours;
  CellNames names;                       // of cells, by their paths
  Units units;                           // that people see
  std::optional<std::string> shellMesh;  // the file that physics.shell.mesh names
  /// [1] Of the shell's volume, the egg's: the shell's semi-axes, or its mesh, are given as a shape alone, and have
  /// been scaled.
  std::optional<double> shellFill;
  bool eggIsStretched = false;  // to the shell's shape: the egg in scene.cells is that one, not from the file
  RecordParameters record;
  CheckParameters check;

  /// Warnings on what works but may not be meant: "file:line:column: path: what; what would be right".
  std::vector<std::string> warnings;

  std::vector<NamedFile> files;
  /// The place at which each value was written, for messages about them: "file:line:column" or "--set path", by path.
  std::map<std::string, std::string> places;

  std::string file;           // as given by the user
  bool allowOutside = false;  // files that it names may lie anywhere
  std::string bytes;          // the file, byte by byte
  // Canonical JSON of every parameter, defaults included; itself a scenario that can be read
  std::string resolved;
  Hash meaning;  // of all that decides results: neither format, comments and key order nor colours count
  std::optional<Hash> referenceMeaning;  // of check.reference, which decides measures and no state; absent without
};

}  // namespace morula
