#include "bench/packed_world.h"

#include <fmt/format.h>

#include <cmath>

#include "base/error.h"
#include "bench/body_file.h"
#include "bench/packing.h"
#include "simulation/measures.h"
#include "simulation/population.h"

namespace morula {
namespace {

// How the state comes about; a change needs a new number, so that old files are not taken for it.
constexpr int recipe = 2;
constexpr double startScale = 0.72;  // of the rest radius: spheres that hardly overlap
constexpr double wantedFill = 0.85;  // of the shell's volume
constexpr double slow = 2e-4;        // rms move per step in edges, below which the cells are at rest
constexpr int leastSteps = 200, mostSteps = 20000;

std::vector<Body> smallSpheres(const World& world, const std::vector<PlacedCell>& places) {
  const int n = static_cast<int>(places.size());
  const double scale = shareRadius(n);
  std::vector<Body> bodies;
  for (const PlacedCell& place : places) {
    Body cell = makeEgg(*world.bodies);
    for (Point& x : cell.position) x = place.centre + (startScale * scale) * x;
    cell.mass /= n;
    cell.pressureConstant /= n;
    cell.restScale = scale;
    bodies.push_back(std::move(cell));
  }
  return bodies;
}

std::vector<Body> allBodies(const World& world) {
  std::vector<Body> bodies;
  for (int slot = 0; slot < world.bodies->count; ++slot) bodies.push_back(takeBody(*world.bodies, slot));
  return bodies;
}

std::vector<CellPath> paths(const std::vector<PlacedCell>& places) {
  std::vector<CellPath> list;
  for (const PlacedCell& place : places) list.push_back(place.path);
  return list;
}

/// Root mean square way of a vertex in one step, in mean rest lengths.
double moveInEdges(const World& world) {
  const WorldMeasures m = measureWorld(world);
  const Bodies& b = *world.bodies;
  const double speed = std::sqrt(2 * m.at("kinetic_energy") / (b.mass(0) * b.count));
  return speed * world.clock.timeStep / (b.mesh.meanRestLength * b.restScale[0]);
}

std::vector<Body> settle(const PackedScene& packed, const std::vector<PlacedCell>& places,
                         const std::function<void(const std::string&)>& tell) {
  tell(fmt::format("packing {} cells of {} vertices; the next bench finds them packed", packed.cells,
                   makeIcosphere(packed.level).vertices.size()));
  const Scene scene = describe({packed.cells, packed.level});
  const World empty = makeWorld(scene);
  World world = makeWorldOf(scene, paths(places), smallSpheres(empty, places), {});
  beginWithBodies(world);
  for (int i = 1; i <= mostSteps; ++i) {
    step(world);
    // Gas that is pressed together is stiff: as the cells swell the time step may grow.
    if (i % 256 == 0) beginWithBodies(world);
    if (i % 32 == 0 && i >= leastSteps && moveInEdges(world) < slow) break;
  }
  const double fill = measureWorld(world)["shell_fill"].value_or(0);
  if (fill < wantedFill) throw BugError(fmt::format("{} cells fill only {:.3f} of their shell", packed.cells, fill));
  return allBodies(world);
}

Hash keyOf(const PackedScene& packed, const Scene& scene) {
  const MechanicsScene& m = *scene.mechanics;
  Hasher h;
  h.field("packed").add(recipe).add(packed.cells).add(packed.level);
  h.field("membrane").add(m.physics.membrane.stiffness).add(m.physics.membrane.damping);
  h.field("pressure").add(m.physics.pressure.constant).add(m.physics.pressure.outside);
  h.field("drag").add(m.physics.drag);
  h.field("contact").add(m.contact->stiffness).add(m.contact->damping).add(m.contact->radius);
  return h.digest();
}

}  // namespace

Scene describe(const PackedScene& packed) {
  Scene scene;
  scene.name = "bench";
  scene.dna = parseDna("START: a0\ng1(a0|a0)\n", "bench");
  scene.cycle.length = 1e9;
  MechanicsScene& m = scene.mechanics.emplace();
  m.mesh = makeIcosphere(packed.level);
  m.physics.drag = 20;
  m.physics.precision = packed.precision;
  if (packed.contact) {
    m.physics.shell = ShellParameters{};
    m.contact = ContactParameters{};
    m.contact->friction = packed.friction;
  }
  return scene;
}

World makeWorldOf(const Scene& scene, const std::vector<CellPath>& paths, const std::vector<Body>& bodies,
                  const Execution& execution) {
  World world = makeWorld(scene, execution);
  const StateId state = world.cells.state[0];
  world.cells = {};
  world.lineage.entries.clear();
  for (const CellPath& path : paths) addFounder(world, path, state);
  setBodies(*world.bodies, bodies);
  return world;
}

std::vector<Body> settledBodies(const PackedScene& packed, const std::filesystem::path& folder,
                                const std::function<void(const std::string&)>& tell) {
  const Hash key = keyOf(packed, describe({packed.cells, packed.level}));
  const auto file = folder / fmt::format("packed-{}x{}.bodies", packed.cells, packed.level);
  if (!folder.empty())
    if (auto bodies = readBodies(file, key)) return *std::move(bodies);
  auto bodies = settle(packed, packBall(packed.cells), tell);
  if (!folder.empty()) writeBodies(file, key, bodies);
  return bodies;
}

World makePackedWorld(const PackedScene& packed, const Execution& execution, const std::filesystem::path& folder,
                      const std::function<void(const std::string&)>& tell) {
  World world =
      makeWorldOf(describe(packed), paths(packBall(packed.cells)), settledBodies(packed, folder, tell), execution);
  beginWithBodies(world);
  return world;
}

}  // namespace morula
