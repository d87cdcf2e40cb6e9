#pragma once
// A scenario that has been read and checked: what to compute (the Scene), what to record and check of it, and how to
// show it.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/hash.h"
#include "observation/reference.h"
#include "state/scene.h"
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
  std::vector<std::uint64_t> atCells;  // rising; the first step with so many cells is a sample too
  std::vector<std::string> measures;   // names of measures on demand [observation/measures.h], taken at every sample
  std::optional<double> meshes;        // [time] between surfaces in the database; absent: none are kept
};

struct Bounds {
  double least = 0, most = 0;
};

/// The comparison with the same scene in Bullet, and its tolerances at the end. If none is given, tolerances that fit
/// the scene hold (engines/bullet_check.h).
struct BulletCheck {
  Baseline baseline = Baseline::b1;  // b1 or b3; b2's springs rest at another length
  double margin = 0.01;              // [radii of the egg] of each surface in Bullet: touching cells are two margins off
  std::optional<double> positions;   // [length] of the vertex that is farthest off
  std::optional<double> radius;      // [1] of each cell's mean distance of vertices from their centre
  std::optional<double> volume;      // [1] of each cell's volume
  std::optional<double> distance;    // [1] of the distance between touching cells' centres, less Bullet's gap
  // [1] of each cell's length over its thickness, by the ellipsoid with its moments
  std::optional<double> aspect;

  bool hasTolerances() const { return positions || radius || volume || distance || aspect; }
};

/// Conditions on a run besides its golden. Nothing here changes what the cells do; absent conditions are not checked.
struct CheckParameters {
  // Conditions at every step, on every cell
  std::optional<Bounds> volume;    // [1] over the volume at rest: the egg's mesh with the cell's rest lengths
  std::optional<double> extent;    // [length] max distance of a vertex from the origin
  std::optional<double> energy;    // [force·length] max kinetic and elastic energy of all cells
  std::optional<double> momentum;  // [mass·length/time] max change of the total momentum since the start
  // Conditions at the end
  std::optional<Bounds> endVolume;     // [1] as `volume`
  std::optional<double> endRoundness;  // [1] min sphericity of a cell
  std::optional<double> endOverlap;    // [1] max mean share of a cell's volume that lies in another cell too
  std::vector<std::string> fails;      // texts that must all be part of the reason for which the run stops; or none
  bool sane = true;                    // false: the scene is about an end that is not sane (core/observation/sanity.h)
  std::string because;                 // the reason for sane = false; else ""
  std::optional<BulletCheck> bullet;   // the comparison with Bullet
  std::optional<Reference> reference;  // the reference of measures that compare the organism
};

/// The colour '#rrggbb' of a cell, a clone or a generation, and its text in the scenario: "clone ABp".
struct CellColour {
  CellSelection cells;
  std::string text, colour;
};

/// A file that a scenario names.
struct NamedFile {
  std::string role;  // "dna", "mesh", "shell", "cells", "names" or "reference"
  std::string path;  // path from which the file was read
  std::string content;
};

struct Scenario {
  std::uint64_t format = 1;
  std::string summary;
  Scene scene;  // ready for makeWorld: DNA parsed, mesh built and scaled
  EggMesh mesh;
  /// Colours '#rrggbb', in lower case, by substance. A name that ends in '*' stands for every substance that begins so.
  std::map<std::string, std::string> colours;
  std::vector<CellColour> cellColours;   // colours of cells, before those of substances
  CellNames names;                       // names of cells, by path
  Units units;                           // units that people see
  std::optional<std::string> shellMesh;  // the file that physics.shell.mesh names
  /// [1] The egg's share of the shell's volume. If present, the shell's semi-axes, or its mesh, were given as a shape
  /// alone and have been scaled.
  std::optional<double> shellFill;
  bool eggIsStretched = false;  // the egg in scene.cells has the shell's shape and is not from the file
  RecordParameters record;
  CheckParameters check;

  /// Warnings on what works but may not be meant: "file:line:column: path: what; what would be right".
  std::vector<std::string> warnings;

  std::vector<NamedFile> files;
  /// The place at which each value was written, for messages about them: "file:line:column" or "--set path", by path.
  std::map<std::string, std::string> places;

  std::string file;           // path of the scenario, as given by the user
  bool allowOutside = false;  // files that the scenario names may lie anywhere
  std::string bytes;          // content of the file
  // Canonical JSON of every parameter, defaults included; can be read as a scenario
  std::string resolved;
  Hash meaning;  // hash of all that decides results; format, comments, key order and colours do not count
  std::optional<Hash> referenceMeaning;  // hash of check.reference, which decides measures and no state
};

}  // namespace morula
