#pragma once
// The scenes of the bench: N cells that fill a spherical shell as if after many divisions, without growing them.
// Parameters are those of scenarios/thesis/elegans-128.yaml, with every cell an N-th of the egg.
// The cells begin evenly spread through a ball, in the order of divisions. Settled bodies take minutes, so they are
// cached in a file, which is made again if it is missing or does not fit.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/cell_path.h"
#include "base/hash.h"
#include "base/vec3.h"
#include "physics/bodies.h"
#include "simulation/simulation.h"

namespace morula {

struct PlacedCell {
  CellPath path;
  Point centre;
};

/// Moves each pair of points in the unit ball that are closer than `distance` apart by a quarter of the missing
/// distance, all at once, and back to `radius` from its centre. Each point's moves are summed in the order of the other
/// points, so that the bits are those of a loop over all pairs.
void pushApart(std::vector<Point>& points, double distance, double radius);

/// Returns `count` ≥ 1 centres in the unit ball, by path, without chance: an additive recurrence spreads them [Roberts
/// 2018], and centres too close push each other apart. Repeated halving across the longest side names them, as division
/// across the longest axis would.
std::vector<PlacedCell> packBall(int count);

/// Returns the radius [length] of a sphere with the share 1/count of the unit ball's volume.
double shareRadius(int count);

struct PackedScene {
  int cells = 64;
  int level = 2;         // level of the icosphere: 1, 2, 3 for 42, 162, 642 vertices
  double viscosity = 0;  // of contacts; elegans-128 has 0.3
  bool contact = true;   // false: no contact and no shell, so cells are independent
  Precision precision = Precision::binary64;
  bool stirred = true;  // false: cells lie still (subject.h)
};

/// Returns the scene for makeWorld. Its one egg is no cell of the packed world.
Scene describe(const PackedScene& packed);

/// Returns a world of the given cells, in which no cell cycle is ever due. Contact forces are not evaluated yet.
World makeWorldOf(const Scene& scene, const std::vector<CellPath>& paths, const std::vector<Body>& bodies,
                  const Execution& execution);

/// Returns the packed cells at rest in their shell: small spheres that Morula lets swell and settle, or those stored in
/// `folder` by an earlier call ("": neither read nor stored). The bits are equal in both cases. Viscosity and contact
/// do not matter for them. `tell`: is called before long work.
std::vector<Body> settledBodies(const PackedScene& packed, const std::filesystem::path& folder,
                                const std::function<void(const std::string&)>& tell);

/// Returns the scene's world with its settled cells.
World makePackedWorld(
    const PackedScene& packed, const Execution& execution = {}, const std::filesystem::path& folder = "",
    const std::function<void(const std::string&)>& tell = [](const std::string&) {});

/// Reads bodies. Returns nothing if the file is missing, has another key, or is damaged.
std::optional<std::vector<Body>> readBodies(const std::filesystem::path& file, const Hash& key);

/// Writes bodies, and makes the folder. Throws FileError, and leaves no incomplete file.
void writeBodies(const std::filesystem::path& file, const Hash& key, const std::vector<Body>& bodies);

}  // namespace morula
