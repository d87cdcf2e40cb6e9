// One scene, one result: whatever the instruction set, the number of threads, and however often it is run.
#include "catch.h"
#include "worlds.h"

using namespace morula;

namespace {

std::vector<Scene> allScenes() {
  Scene mixed = scenes::life(scenes::cube());
  mixed.name = "life of a cube";
  Scene ring = scenes::life(scenes::scaled(zoo::torus(7, 5), 0.33));
  ring.name = "life of a torus";
  ring.mechanics->division = {DivisionPlane::axis, {1, 0, 0}};
  std::vector<Scene> scenes{scenes::packed(),    scenes::ellipsoid(), scenes::thesis(), scenes::life(), mixed, ring,
                            scenes::coarsening()};
  scenes.push_back(scenes::spheres());
  scenes.push_back(scenes::sensing());
  scenes.push_back(scenes::sticky());
  Scene stickySpheres = scenes::spheres();
  stickySpheres.name = "sticky spheres";
  stickySpheres.mechanics->contact->adhesion = AdhesionParameters{1, {}};
  stickySpheres.mechanics->physics.motility = MotilityParameters{0.2, 0.3};
  scenes.push_back(stickySpheres);
  scenes.push_back(scenes::turning());
  scenes.push_back(scenes::varied());
  for (Scene single : {scenes::packed(), scenes::thesis(), ring, scenes::spheres(), scenes::sticky(), stickySpheres}) {
    single.name += " in single precision";
    single.mechanics->physics.precision = Precision::binary32;
    scenes.push_back(single);
  }
  for (Scene shapes : {scenes::life(), scenes::ellipsoid(), scenes::coarsening()}) {
    shapes.name += " by shape matching";
    shapes.mechanics->physics.cell.model = CellModel::shapeMatching;
    shapes.mechanics->physics.shapeMatching = {400, 0.5, 4};
    scenes.push_back(shapes);
  }
  for (auto [integrator, name] : {std::pair{Integrator::explicitEuler, "explicit Euler"},
                                  {Integrator::symplecticEuler, "symplectic Euler"},
                                  {Integrator::rungeKutta4, "Runge-Kutta"},
                                  {Integrator::xpbd, "XPBD"}}) {
    Scene other = scenes::ellipsoid();
    other.name += std::string(" by ") + name;
    other.mechanics->physics.integrator = integrator;
    if (integrator == Integrator::xpbd) other.mechanics->physics.substeps = 3;
    other.mechanics->physics.drag = 5;  // or explicit Euler's steps are tiny
    other.stop.time = integrator == Integrator::explicitEuler ? 3.1 : 3.5;
    scenes.push_back(other);
  }
  for (const Scene& events : {scenes::sticky(), scenes::spheres(), scenes::coarsening()})
    scenes.push_back(scenes::settling(events));
  scenes.push_back(scenes::settling(scenes::packed()));
  scenes.back().name += " in single precision";
  scenes.back().mechanics->physics.precision = Precision::binary32;
  return scenes;
}

/// Of the forces; in a run through time there is one in each step, at least.
std::uint64_t evaluationsOf(const World& world) {
  std::uint64_t count = world.clock.step;
  if (world.settlings)
    for (const SettlingRecord& settling : *world.settlings) count += settling.evaluations;
  return count;
}

/// The states of a run to its end, the first before any step, or `most` and one more.
std::vector<Hash> statesOf(World& world, std::size_t most = SIZE_MAX) {
  std::vector<Hash> states{stateHash(world)};
  for (; !finished(world) && states.size() <= most; states.push_back(stateHash(world))) step(world);
  return states;
}

}  // namespace

TEST_CASE(
    "Every instruction set and any number of threads goes through the scalar one's states, and again in one process") {
  std::vector<Execution> others;
  for (const Isa isa : availableIsas())
    if (isa != Isa::scalar) others.push_back({isa, 1});
  for (const int threads : {2, 3, 7}) others.push_back({bestIsa(), threads});
  for (const Scene& scene : allScenes()) {
    World first = makeWorld(scene, {Isa::scalar, 1});
    const std::vector<Hash> states = statesOf(first);
    // One after the other: threads that wait for work would take time from those that have some.
    for (const Execution& other : others) {
      World world = makeWorld(scene, other);
      const std::vector<Hash> found = statesOf(world, states.size());
      const auto different = std::ranges::mismatch(states, found).in1 - states.begin();
      CAPTURE(scene.name, name(other.isa), other.threads, different);
      CHECK(found == states);
    }
    CAPTURE(scene.name);
    CHECK(evaluationsOf(first) > (first.settlings ? 50 : 300));  // balls settle soon
    CHECK(first.lineage.entries.size() >= 7);
    ranToEnd(scenes::lineageOnly(scenes::uniqueFour, 5));  // another world in between
    CHECK(stateHash(ranToEnd(scene, {bestIsa(), 1})) == states.back());
  }
}

TEST_CASE("Seventeen cells on three blocks and several threads, lists built at different times") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(1));
  scene.mechanics->contact = scenes::pairContactWithFriction;
  const auto cells = flyingCells(makeIcosphere(1), 17, 2.2, 1);
  World lazy = worldOf(scene, cells, {Isa::scalar, 1}), eager = worldOf(scene, cells, {bestIsa(), 3});
  std::int64_t different = 0;
  for (int i = 0; i < 300; ++i) {
    eager.contacts->listIsValid = false;
    step(lazy);
    step(eager);
    different += stateHash(lazy) != stateHash(eager);
  }
  CHECK(different == 0);
  CHECK(lazy.contacts->rebuilds < eager.contacts->rebuilds / 2);
}

TEST_CASE("Another seed is another result where chance plays a part, and only there") {
  Scene random = scenes::ellipsoid(), fixed = scenes::thesis();
  const Hash a = stateHash(ranToEnd(random, {bestIsa(), 1})), b = stateHash(ranToEnd(fixed, {bestIsa(), 1}));
  random.seed = fixed.seed = 2;
  CHECK(stateHash(ranToEnd(random, {bestIsa(), 1})) != a);
  CHECK(stateHash(ranToEnd(fixed, {bestIsa(), 1})) == b);
}
