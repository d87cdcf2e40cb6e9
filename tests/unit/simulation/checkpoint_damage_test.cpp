// A checkpoint that is not what it should be is refused, and the world stays as it was.
#include <cstring>
#include <functional>

#include "base/random.h"
#include "catch.h"
#include "simulation/checkpoint.h"
#include "simulation/saved_state.h"
#include "worlds.h"

using namespace morula;

namespace {

constexpr std::size_t headSize = 24, tailSize = 16;

World lived() {
  World world = makeWorld(scenes::life(), {bestIsa(), 1});
  while (world.clock.time < 4.1) step(world);
  return world;
}

/// What restoring says of it, or "".
std::string complaint(World& world, const std::string& checkpoint) {
  try {
    restoreState(world, checkpoint);
  } catch (const InputError& e) { return e.what(); }
  return "";
}

std::string complaint(const std::string& checkpoint, const Scene& scene = scenes::life()) {
  World world = makeWorld(scene, {bestIsa(), 1});
  const Hash before = stateHash(world);
  const std::string text = complaint(world, checkpoint);
  if (!text.empty()) CHECK(stateHash(world) == before);
  return text;
}

std::string withByte(std::string bytes, std::size_t at, int change) {
  bytes[at] = static_cast<char>(bytes[at] ^ change);
  return bytes;
}

/// With the hash that its content now has, as by somebody who knows the format.
std::string sealedAgain(std::string bytes) {
  std::uint64_t version;
  std::memcpy(&version, bytes.data() + 8, 8);
  Hasher h;
  h.field("checkpoint")
      .add(version)
      .add(std::string_view(bytes).substr(headSize, bytes.size() - headSize - tailSize));
  const Hash hash = h.digest();
  std::memcpy(bytes.data() + bytes.size() - 16, &hash.high, 8);
  std::memcpy(bytes.data() + bytes.size() - 8, &hash.low, 8);
  return bytes;
}

}  // namespace

TEST_CASE("Cut short at any length, a checkpoint is refused") {
  const std::string whole =
      saveState(makeWorld(scenes::lineageOnly(scenes::uniqueFour, 5), {Isa::scalar, 1}));
  World world = makeWorld(scenes::lineageOnly(scenes::uniqueFour, 5), {Isa::scalar, 1});
  for (std::size_t length = 0; length < whole.size(); ++length) {
    CAPTURE(length);
    CHECK_THAT(complaint(world, whole.substr(0, length)), ContainsSubstring("checkpoint: "));
  }
  CHECK(complaint(world, whole).empty());
  CHECK_THAT(complaint(world, whole.substr(0, 100)), ContainsSubstring("cut short: 100 bytes"));
  CHECK_THAT(complaint(world, whole + "x"), ContainsSubstring("more bytes follow"));
}

TEST_CASE("Any flipped bit of a checkpoint is noticed") {
  const std::string whole =
      saveState(makeWorld(scenes::lineageOnly(scenes::uniqueFour, 5), {Isa::scalar, 1}));
  World world = makeWorld(scenes::lineageOnly(scenes::uniqueFour, 5), {Isa::scalar, 1});
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (int bit = 0; bit < 8; ++bit)
      if (complaint(world, withByte(whole, at, 1 << bit)).empty()) FAIL("byte " << at << ", bit " << bit);
  CHECK_THAT(complaint(world, withByte(whole, 0, 1)), ContainsSubstring("these bytes are not a checkpoint"));
  CHECK_THAT(complaint(world, withByte(whole, 8, 1)), ContainsSubstring("has format 3"));
  CHECK_THAT(complaint(world, withByte(whole, headSize + 50, 1)), ContainsSubstring("damaged"));
}

TEST_CASE("Damage behind a hash that fits is refused too, or is a state that can be gone on with") {
  const std::string whole = saveState(lived());
  REQUIRE(complaint(sealedAgain(whole)).empty());
  World world = makeWorld(scenes::life(), {bestIsa(), 1});
  int refused = 0, taken = 0;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const auto random = randomWords({7, {}, 0, Purpose::test}, i);
    // Most bytes are coordinates; what holds a state together stands before them.
    const std::size_t size = i % 3 == 0 ? whole.size() - headSize - tailSize : 6000;
    const std::string bytes = sealedAgain(withByte(whole, headSize + random[0] % size, 1 + random[1] % 255));
    if (!complaint(world, bytes).empty()) {
      ++refused;
      continue;
    }
    ++taken;
    try {
      step(world);
    } catch (const NumericalError&) {  // an absurd state may end the run, with a message
    }
  }
  CHECK(refused > 500);
  CHECK(taken > 500);
}

TEST_CASE("A checkpoint of another scene is refused, and the message says what differs") {
  const std::string saved = saveState(lived());
  const auto differs = [&](const char* part, const std::function<void(Scene&)>& change) {
    Scene other = scenes::life();
    change(other);
    CAPTURE(part);
    CHECK_THAT(complaint(saved, other),
               ContainsSubstring(std::string("another scene; this one differs in: ") + part));
  };
  differs("dna", [](Scene& s) { s.dna = parseDna(scenes::uniqueFour, "test.dna"); });
  differs("cycle", [](Scene& s) { s.cycle.length = 1.5; });
  differs("seed", [](Scene& s) { s.seed = 2; });
  differs("physics", [](Scene& s) { s.mechanics->physics.drag = 0.31; });
  differs("physics.mesh", [](Scene& s) { s.mechanics->mesh = scenes::scaled(makeIcosphere(1), 0.94); });
  differs("physics.contact", [](Scene& s) { s.mechanics->contact->friction = 0.2; });
  differs("physics.contact", [](Scene& s) { s.mechanics->contact.reset(); });
  differs("division", [](Scene& s) { s.mechanics->division.plane = DivisionPlane::random; });
  differs("connections", [](Scene& s) { s.mechanics->connections->releaseDistance.reset(); });
  differs("physics, physics.mesh, physics.contact, division, connections",
          [](Scene& s) { s.mechanics.reset(); });
}

TEST_CASE("A state whose parts contradict each other is refused") {
  const World world = lived();
  const SavedState good = describeState(world);
  REQUIRE_NOTHROW(checkSavedState(good, world));
  const auto refused = [&](const char* why, const std::function<void(SavedState&)>& change) {
    SavedState bad = good;
    change(bad);
    CAPTURE(why);
    CHECK_THROWS_WITH(checkSavedState(bad, world), ContainsSubstring(why));
  };
  refused("the clock", [](SavedState& s) { s.time = INFINITY; });
  refused("the clock", [](SavedState& s) { s.epochStep = s.step + 1; });
  refused("the time step", [](SavedState& s) { s.timeStep = 0; });
  refused("no substance 'a99'", [](SavedState& s) { s.states[0] = std::string("a99"); });
  refused("sorted", [](SavedState& s) { s.states[0] = std::string("a1 a0"); });
  refused("no state", [](SavedState& s) { s.cells.state[0] = s.states.size(); });
  refused("cells have columns of different lengths", [](SavedState& s) { s.cells.growth.pop_back(); });
  refused("only the letters A and B", [](SavedState& s) { s.lineage.path[0] = std::string("X"); });
  refused("at most 120", [](SavedState& s) { s.lineage.path[0] = std::string(121, 'A'); });
  refused("unknown fate", [](SavedState& s) { s.lineage.fate[0] = 3; });
  refused("not those of the lineage", [](SavedState& s) { s.lineage.fate[0] = 0; });
  refused("order of cells", [](SavedState& s) {
    std::swap(s.cells.path[0], s.cells.path[1]);
    std::swap(s.cells.entry[0], s.cells.entry[1]);
  });
  refused("is not in the lineage", [](SavedState& s) { s.cells.entry[0] = s.lineage.path.size(); });
  refused("time of a cell cycle", [](SavedState& s) { s.cells.lastCycle[0] = -INFINITY; });
  refused("a mesh that the scene has not", [](SavedState& s) { s.bodies.coarseness[0] = 1; });
  refused("bodies have columns", [](SavedState& s) { s.bodies.velocity.pop_back(); });
  refused("mass or size", [](SavedState& s) { s.bodies.vertexMass[0] = -1; });
  refused("influence radius", [](SavedState& s) { s.contacts.radius[0] = INFINITY; });
  refused("contacts have columns", [](SavedState& s) { s.contacts.reference.pop_back(); });
  refused("contacts have columns", [](SavedState& s) { s.contacts.counters.pop_back(); });
  refused("a connection of", [](SavedState& s) { s.connections.cause[0] = std::string("boredom"); });
  refused("a connection of", [](SavedState& s) { std::swap(s.connections.a[0], s.connections.b[0]); });
  refused("a connection of", [](SavedState& s) { s.connections.released[0] = -1; });
}

TEST_CASE("A checkpoint knows sub-steps and what keeps its cells in shape") {
  Scene scene = scenes::life();
  scene.mechanics->physics.integrator = Integrator::xpbd;
  scene.mechanics->physics.substeps = 2;
  Scene shapes = scenes::life();
  shapes.mechanics->physics.cell.model = CellModel::shapeMatching;
  const std::string bySteps = saveState(makeWorld(scene)), byShapes = saveState(makeWorld(shapes));
  const auto differs = [](const std::string& saved, Scene other,
                          const std::function<void(PhysicsParameters&)>& change) {
    change(other.mechanics->physics);
    CHECK_THAT(complaint(saved, other), ContainsSubstring("another scene; this one differs in: physics"));
  };
  CHECK(complaint(bySteps, scene) == "");
  CHECK(complaint(byShapes, shapes) == "");
  differs(bySteps, scene, [](PhysicsParameters& p) { p.substeps = 3; });
  differs(byShapes, shapes, [](PhysicsParameters& p) { p.cell.model = CellModel::shell; });
  differs(byShapes, shapes, [](PhysicsParameters& p) { p.shapeMatching.stiffness = 401; });
  differs(byShapes, shapes, [](PhysicsParameters& p) { p.shapeMatching.linear = 0.25; });
  differs(byShapes, shapes, [](PhysicsParameters& p) { p.shapeMatching.damping = 5; });
}
