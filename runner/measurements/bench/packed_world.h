#pragma once
// The scenes that the bench times: N cells that fill a spherical shell as after many divisions, without
// growing them. Parameters: those of scenarios/thesis/elegans-128.yaml, with every cell an N-th of the egg.
#include <filesystem>
#include <functional>
#include <string>

#include "simulation/world.h"

namespace morula {

struct PackedScene {
  int cells = 64;
  int level = 2;        // of the icosphere: 1, 2, 3 for 42, 162, 642 vertices
  double friction = 0;  // Coulomb's coefficient; elegans-128 has 0.3
  bool contact = true;  // false: no contact and no shell: each cell for itself
  Precision precision = Precision::binary64;
};

/// What makeWorld needs for it. Its one egg stands for no cell of the packed world.
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
World makePackedWorld(const PackedScene& packed, const Execution& execution, const std::filesystem::path& folder,
                      const std::function<void(const std::string&)>& tell);

}  // namespace morula
