// usesSeed: true exactly where two seeds give two results.
#include "catch.h"
#include "scenes.h"
#include "simulation/hash.h"

using namespace morula;

namespace {

std::string endOf(Scene scene, std::uint64_t seed) {
  scene.seed = seed;
  World world = makeWorld(scene);
  while (!finished(world)) step(world);
  return hashState(world).whole.text();
}

}  // namespace

TEST_CASE("a scene says that it uses its seed exactly if another seed gives another result") {
  const std::string rests = "START: a0\ng1(a0|a0)\n";
  const std::vector<std::pair<std::string, Scene>> scenes{
      {"lineage", scenes::lineageOnly(scenes::uniqueFour, 4)},
      {"bodies", scenes::withBodies(scenes::everybodyDivides, 2)},
      {"bodies at rest", scenes::withBodies(rests, 2)},
      {"packed", scenes::packed()},
      {"ellipsoid", scenes::ellipsoid()},
      {"life", scenes::life()},
      {"spheres", scenes::spheres()},
      {"mixed meshes", scenes::mixedMeshes()},
      {"coarsening", scenes::coarsening()}};
  for (const auto& [name, scene] : scenes)
    for (const DivisionPlane plane : {DivisionPlane::longest, DivisionPlane::axis, DivisionPlane::random}) {
      Scene s = scene;
      s.cycle.length = 0.0625;  // two cycles, and what they draw, are enough
      s.stop = {.cycles = 2, .time = {}, .cells = {}};
      if (!s.mechanics && plane != DivisionPlane::longest) continue;
      if (s.mechanics) s.mechanics->division.otherwise.plane = plane;
      if (s.mechanics && s.mechanics->physics.cell.model == CellModel::sphere &&
          plane == DivisionPlane::longest)
        continue;  // a sphere has none
      CAPTURE(name, static_cast<int>(plane));
      CHECK(usesSeed(s) == (endOf(s, 1) != endOf(s, 2)));
    }
}
