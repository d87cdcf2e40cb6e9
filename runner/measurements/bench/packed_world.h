#pragma once
// The scenes that the bench times: N cells that fill a spherical shell as after many divisions, without
// growing them. Parameters: those of scenarios/thesis/elegans-128.yaml, with every cell an N-th of the egg.
// Bodies are kept between two calls of the program, so that what took minutes is there at once. A cache: where there is
// no file, or another one than expected, they are made again.
// They begin spread evenly through a ball, in the order that divisions would give.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/cell_path.h"
#include "base/hash.h"
#include "base/vec3.h"
#include "physics/bodies.h"
#include "simulation/world.h"

namespace morula {

struct PlacedCell {
  CellPath path;
  Point centre;
};

/// `count` ≥ 1 centres in the unit ball, by path. Without chance: an additive recurrence spreads them
/// [Roberts 2018], those too near push each other apart, and halving across the longest side of what is left
/// names them, as division across the longest axis would.
std::vector<PlacedCell> packBall(int count);

/// [length] of the sphere whose volume is a share 1/count of the unit ball's.
double shareRadius(int count);

struct PackedScene {
  int cells = 64;
  int level = 2;        // of the icosphere: 1, 2, 3 for 42, 162, 642 vertices
  double friction = 0;  // Coulomb's coefficient; elegans-128 has 0.3
  bool contact = true;  // false: no contact and no shell: each cell for itself
  Precision precision = Precision::binary64;
};

/// Returns the scene that makeWorld needs. Its one egg stands for no cell of the packed world.
Scene describe(const PackedScene& packed);

/// A world of the given cells, in which no cell cycle is ever due. Contact forces are not evaluated yet.
World makeWorldOf(const Scene& scene, const std::vector<CellPath>& paths, const std::vector<Body>& bodies,
                  const Execution& execution);

/// The packed cells at rest in their shell: small spheres that our own engine lets swell and settle, or what
/// an earlier call has left in `folder` ("": neither looked for nor left). Friction and contact do not count
/// for it. The same bits in either case. `tell` is called with what takes time.
std::vector<Body> settledBodies(const PackedScene& packed, const std::filesystem::path& folder,
                                const std::function<void(const std::string&)>& tell);

/// Both together: the scene's world with its settled cells.
World makePackedWorld(
    const PackedScene& packed, const Execution& execution = {}, const std::filesystem::path& folder = "",
    const std::function<void(const std::string&)>& tell = [](const std::string&) {});

/// Nothing if there is no such file, if it was written under another key, or if it is damaged.
std::optional<std::vector<Body>> readBodies(const std::filesystem::path& file, const Hash& key);

/// Makes the folder too. Throws FileError; no half-written file stays.
void writeBodies(const std::filesystem::path& file, const Hash& key, const std::vector<Body>& bodies);

}  // namespace morula
