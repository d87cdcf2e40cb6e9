// usesSeed is true exactly if two seeds give two results.
#include <functional>

#include "catch.h"
#include "unit/simulation/worlds.h"

using namespace morula;

namespace {

const std::string rests = "START: a0\ng1(a0|a0)\n";

std::string endOf(Scene scene, std::uint64_t seed) {
  scene.seed = seed;
  return stateHash(ranToEnd(scene)).text();
}

}  // namespace

TEST_CASE("a scene says that it uses its seed exactly if another seed gives another result") {
  const std::vector<std::pair<std::string, Scene>> scenes{{"lineage", scenes::lineageOnly(scenes::uniqueFour, 4)},
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
      s.cycle.length = 0.0625;  // two cycles of draws are enough
      s.stop = {.cycles = 2, .time = {}, .cells = {}};
      if (!s.mechanics && plane != DivisionPlane::longest) continue;
      if (s.mechanics) s.mechanics->division.otherwise.plane = plane;
      if (s.mechanics && s.mechanics->physics.cell.model == CellModel::sphere && plane == DivisionPlane::longest)
        continue;  // a sphere has no longest axis
      CAPTURE(name, static_cast<int>(plane));
      CHECK(usesSeed(s) == (endOf(s, 1) != endOf(s, 2)));
    }
}

TEST_CASE("a scene whose rules or variation draw uses its seed exactly if another seed gives another result") {
  const auto changes = std::vector<std::pair<const char*, std::function<void(Scene&)>>>{
      {"nothing", [](Scene&) {}},
      {"rule without noise",
       [](Scene& s) { s.mechanics->division.rules = {{.of = {"a*"}, .share = 0.4, .tilt = 0.0}}; }},
      {"tilt of a rule", [](Scene& s) { s.mechanics->division.rules = {{.of = {"a*"}, .tilt = 5.0}}; }},
      {"random by a rule",
       [](Scene& s) { s.mechanics->division.rules = {{.of = {"a*"}, .plane = {{DivisionPlane::random}}}}; }},
      {"variation of cycles", [](Scene& s) { s.variation.cycle = 0.1; }},
      {"variation of shares", [](Scene& s) { s.variation.share = 0.05; }},
      {"variation of places", [](Scene& s) { s.variation.start = 0.05; }},
      {"variation of axes", [](Scene& s) { s.variation.tilt = 5; }}};
  for (const auto& [what, change] : changes)
    for (const bool divides : {true, false})
      for (const bool hasBodies : {true, false}) {
        Scene s = scenes::withBodies(divides ? scenes::everybodyDivides : rests, 2);
        s.cycle.length = 0.0625;
        change(s);
        if (!hasBodies) s.mechanics.reset();
        CAPTURE(what, divides, hasBodies);
        CHECK(usesSeed(s) == (endOf(s, 1) != endOf(s, 2)));
      }
}

TEST_CASE("an experiment on a share of the cells uses the seed, one on all of them does not") {
  Scene scene = scenes::lineageOnly(scenes::everybodyDivides, 4);
  const CellSelection all{.kind = CellSelection::Kind::substance, .substance = "*"};
  scene.experiments = {{.deed = Deed::delay, .of = {all}, .value = 0.5, .atCells = 4}};
  CHECK_FALSE(usesSeed(scene));
  CHECK(endOf(scene, 1) == endOf(scene, 2));
  scene.experiments[0].share = 0.5;
  CHECK(usesSeed(scene));
  CHECK(endOf(scene, 1) != endOf(scene, 2));
}
