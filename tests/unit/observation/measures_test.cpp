// Measures of a world agree with its meshes.
#include <numbers>
#include <set>

#include "catch.h"
#include "mesh/overlap.h"
#include "observation/body_measures.h"
#include "physics/shell_surface.h"
#include "unit/simulation/worlds.h"

using namespace morula;

TEST_CASE("Each cell's measures are those of its mesh") {
  const World world = ranTo(scenes::packed(), 3.5);
  const auto cells = measureCells(world);
  REQUIRE(cells.size() == 8);
  double total = 0, pressures = 0;
  Worst outermost;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CellMeasures& m = cells[i];
    CHECK(m.path == world.cells.path[i]);
    CHECK(m.state == world.cells.state[i]);
    const auto x = cellVertices(world, m.path);
    const auto& faces = world.model.mechanics->mesh.faces;
    CHECK(m.at("volume") == Approx(measureVolume(x, faces)).epsilon(1e-14));
    CHECK(m.at("volume") == Approx(world.bodies->volume[i]).epsilon(1e-12));
    CHECK(m.at("area") == measureArea(x, faces));
    CHECK(m.at("pressure") == Approx(world.bodies->pressure[i]).epsilon(1e-9));
    CHECK(m.at("sphericity") == sphericity(m.at("volume"), m.at("area")));
    CHECK(m.at("sphericity") < 1);
    CHECK(Point{m.at("x"), m.at("y"), m.at("z")} == measureCentroid(x));
    CHECK(m.at("neighbours") >= 3);
    total += m.at("volume");
    pressures += m.at("pressure") / 8;
    for (const Point& p : x)
      outermost.see(norm(heldPoint(p, *world.model.mechanics->physics.shell, world.bodies->sag[i])));
  }
  const WorldMeasures w = measureWorld(world);
  CHECK(w.time == world.clock.time);
  CHECK(w.step == world.clock.step);
  CHECK(w.at("cells") == 8);
  CHECK(w.at("volume") == Approx(total).epsilon(1e-12));
  CHECK(w.at("mean_pressure") == Approx(pressures).epsilon(1e-9));
  CHECK(w.at("shell_fill") == Approx(total / (4 * std::numbers::pi / 3)).epsilon(1e-12));
  CHECK(w.at("shell_fill") > 0.5);
  CHECK(w.at("outermost") == Approx(outermost).epsilon(1e-14));
  CHECK(w.at("outermost") <= 1 + 1e-12);
}

TEST_CASE("Contacts are by pairs of paths and agree with the neighbours counted") {
  const World world = ranTo(scenes::packed(), 3.5);
  std::vector<int> neighbours(8);
  const auto contacts = measureContacts(world);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    CHECK(contacts[i].a < contacts[i].b);
    CHECK(contacts[i].at("area") > 0);
    if (i > 0) CHECK(std::pair(contacts[i - 1].a, contacts[i - 1].b) < std::pair(contacts[i].a, contacts[i].b));
    for (const CellPath& p : {contacts[i].a, contacts[i].b}) ++neighbours[slotOf(world, p.text().c_str())];
  }
  const auto cells = measureCells(world);
  for (int i = 0; i < 8; ++i) CHECK(cells[i].at("neighbours") == neighbours[i]);
}

TEST_CASE("Kinetic energy is that of the vertices; in an ellipsoid the outermost vertex is measured in its axes") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1);
  scene.mechanics->physics.shell = ShellParameters{{2, 1.5, 1.25}};
  World world = makeWorld(scene);
  for (int v = 0; v < world.bodies->vertexCount(); ++v) world.bodies->velocity[world.bodies->at(0, v)] = 3;
  CHECK(measureWorld(world).at("kinetic_energy") == Approx(0.5 * 1 * 9).epsilon(1e-14));
  Worst outermost;
  for (const Point& x : cellVertices(world, CellPath{})) {
    const Point p = heldPoint(x, *scene.mechanics->physics.shell, world.bodies->sag[0]);
    outermost.see(std::sqrt(p.x * p.x / 4 + p.y * p.y / 2.25 + p.z * p.z / 1.5625));
  }
  CHECK(measureWorld(world).at("outermost") == Approx(outermost).epsilon(1e-14));
}

TEST_CASE("Energy, volume and pressure are of all cells") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1);
  Body left = ballAt(scene.mechanics->mesh, {}, 200), right = ballAt(scene.mechanics->mesh, {0, 5, 0}, 100);
  right.mass = 3;
  for (Vector& u : left.velocity) u = {2, 0, 0};
  for (Vector& u : right.velocity) u = {0, 0, 4};
  const World world = worldOf(scene, {left, right});
  const WorldMeasures m = measureWorld(world);
  const double volume = measureVolume(left.position, scene.mechanics->mesh.faces);
  CHECK(m.at("kinetic_energy") == Approx(0.5 * 1 * 4 + 0.5 * 3 * 16).epsilon(1e-13));
  CHECK(m.at("volume") == Approx(2 * volume).epsilon(1e-13));
  CHECK(m.at("mean_pressure") == Approx(150 / volume - 200 / volume).epsilon(1e-12));
}

TEST_CASE("The mean overlap of two balls is the lens they share") {
  const Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(3));
  for (double distance : {0.5, 1.5, 2.5}) {
    const World world = ballsAt(scene, {{}, {0, distance, 0}});
    const double lens = distance < 2 ? std::numbers::pi * (4 + distance) * (2 - distance) * (2 - distance) / 12 : 0;
    CHECK(measureMeanOverlap(*world.bodies, nullptr) == Approx(lens / (4 * std::numbers::pi / 3)).margin(0.01));
  }
}

TEST_CASE("A path that does not live has no vertices") {
  const World world = makeWorld(scenes::withBodies(scenes::uniqueFour, 1));
  CHECK(cellVertices(world, CellPath{}) == world.model.mechanics->mesh.vertices);
  CHECK(cellVertices(world, CellPath::parse("A")).empty());
}

namespace {

template <class Of>
void checkTable() {
  std::set<std::string> names;
  bool onDemand = false;
  for (const Measure<Of>& m : measures<Of>()) {
    INFO(m.name);
    CHECK(names.insert(m.name).second);
    CHECK(std::string(m.name).find_first_not_of("abcdefghijklmnopqrstuvwxyz_123") == std::string::npos);  // a column
    CHECK(std::string(m.meaning).find_first_of("\n|") == std::string::npos);  // a cell of a table
    onDemand |= m.taken == Taken::onDemand;
    CHECK(onDemand == (m.taken == Taken::onDemand));  // measures of samples come first
  }
}

double valueOf(const char* name, const World& world, int cell) {
  const Observation now(world);
  return *measure<CellContext>(name).get(ObservedCell(now, cell));
}

}  // namespace

TEST_CASE("The tables of measures: names are columns, each once; those that samples hold stand first") {
  checkTable<Observation>();
  checkTable<CellContext>();
  checkTable<Touch>();
}

TEST_CASE("A value that was not measured is absent, and asking for it regardless is a bug") {
  CellMeasures m;
  for (const auto& value : m.values) CHECK_FALSE(value);
  CHECK_THROWS_AS(m.at("volume"), BugError);
  CHECK_THROWS_AS(m["no such"], BugError);
  CHECK_THROWS_AS(m["volume_over_rest"], BugError);  // taken on demand only
  CHECK_THROWS_AS(measure<CellContext>("no such"), BugError);
  m["volume"] = 2;
  CHECK(m.at("volume") == 2);
}

TEST_CASE("Without bodies cells are counted and nothing is measured; without a shell nothing of a shell") {
  const World lineage = makeWorld(scenes::lineageOnly(scenes::uniqueFour, 3));
  const WorldMeasures m = measureWorld(lineage);
  CHECK(m.at("cells") == 1);
  for (const WorldMeasure& row : sampledMeasures<Observation>())
    if (row.needs != Needs::nothing) CHECK_FALSE(m[row.name]);
  const WorldMeasures open = measureWorld(makeWorld(scenes::withBodies(scenes::uniqueFour, 1)));
  CHECK(open["volume"]);
  CHECK_FALSE(open["shell_fill"]);
  CHECK_FALSE(open["outermost"]);
}

TEST_CASE("Volume over rest and over the mesh: a body pressed to nine tenths, with half the egg's contents") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1);
  scene.mechanics->physics.pressure.constant = 4;
  Body body = shakenBody(scene.mechanics->mesh, 0, 0);
  for (Point& x : body.position) x = 0.9 * x;
  body.pressureConstant = 2;
  body.restScale = 0.95;
  const World world = worldOf(scene, {body});
  CHECK(valueOf("volume_over_rest", world, 0) == Approx(0.729 / 0.5).epsilon(1e-12));
  CHECK(valueOf("volume_over_mesh", world, 0) == Approx(0.729 / (0.95 * 0.95 * 0.95)).epsilon(1e-12));
  scene.mechanics->physics.cell.model = CellModel::shapeMatching;  // no contents: the mesh is the rest shape
  CHECK(valueOf("volume_over_rest", worldOf(scene, {body}), 0) == Approx(0.729 / (0.95 * 0.95 * 0.95)).epsilon(1e-12));
}

TEST_CASE("Inverted: nothing of a ball, all of one that is turned inside out") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(2));
  Body body = shakenBody(scene.mechanics->mesh, 0, 0);
  World world = worldOf(scene, {body});
  CHECK(valueOf("inverted", world, 0) == 0);
  for (int v = 0; v < world.bodies->vertexCount(); ++v)
    world.bodies->write(world.bodies->position, 0, v, -world.bodies->vertex(0, v));
  CHECK(valueOf("inverted", world, 0) == 1);
}

TEST_CASE("Elongation: a ball and a disc have none, twice as long is 2, whatever the size and the direction") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(2));
  for (const auto& [stretch, expected] : {std::pair(Vector{1, 1, 1}, 1.0),
                                          {Vector{0.4, 1, 1}, 1.0},
                                          {Vector{1, 2, 1}, 2.0},
                                          {Vector{0.5, 1, 1.5}, 1.5}}) {
    Body body = shakenBody(scene.mechanics->mesh, 0, 0);
    for (Point& x : body.position) {
      x = Point{stretch.x * x.x, stretch.y * x.y, stretch.z * x.z};
      x = 3 * Point{0.6 * x.x - 0.8 * x.y, 0.8 * x.x + 0.6 * x.y, x.z} + Vector{1, 2, 3};
    }
    CHECK(valueOf("elongation", worldOf(scene, {body}), 0) == Approx(expected).epsilon(1e-6));
  }
  CHECK(valueOf("elongation", makeWorld(scenes::spheres()), 0) == 1);
}

TEST_CASE("Extent and momentum: a ball that flies, far out") {
  const Scene scene = scenes::withBodies(scenes::uniqueFour, 1);
  Body body = ballAt(scene.mechanics->mesh, {0, 10, 0});
  for (Vector& u : body.velocity) u = {1, 2, -3};
  body.mass = 4;
  const World world = worldOf(scene, {body});
  const Observation now(world);
  const auto of = [&](const char* name) { return *measure<Observation>(name).get(now); };
  Worst extent;
  for (const Point& x : body.position) extent.see(norm(x));
  CHECK(of("extent") == extent);
  CHECK(of("momentum_x") == Approx(4).epsilon(1e-13));
  CHECK(of("momentum_y") == Approx(8).epsilon(1e-13));
  CHECK(of("momentum_z") == Approx(-12).epsilon(1e-13));
  CHECK(of("energy") >= 0.5 * 4 * 14 * (1 - 1e-12));
}
