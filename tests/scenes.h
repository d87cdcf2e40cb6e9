#pragma once
// Scenes that tests of several folders share. Each scene sets all its numbers, so that new defaults do not change it.
#include <string>

#include "mesh/mesh_measures.h"
#include "simulation/simulation.h"
#include "unit/mesh/zoo.h"

namespace morula::scenes {

inline const std::string everybodyDivides = "START: a0\ng1(a0|a0)\ng2(divide|a0)\n";

// DNA whose lineage ends with four different cells [Nilsson 2008, §5.2.1].
inline const std::string uniqueFour =
    "START: a0\n"
    "g1(a1|a0)\ng2(divide|a0)\ng3(a2|a1,A)\ng4(a3|a1,B)\ng5(divide|a1)\ng6(a4|a2,A)\ng7(a5|a2,B)\ng8(a6|a3,A)\n"
    "g9(a7|a3,B)\ng10(a4|a4)\ng11(a5|a5)\ng12(a6|a6)\ng13(a7|a7)\n";

// DNA with every action: seven cells, then a death, growth, shrinkage, and connections made and released by genes.
inline const std::string eventful =
    "START: a0\n"
    "g1(a1|a0)\ng2(divide|a0)\n"
    "g3(a2|a1,A)\ng4(a3|a1,B)\ng5(divide|a1)\ng6(connect|a1)\n"
    "g7(a4|a2,A)\ng8(a5|a2,B)\ng9(a6|a3,A)\ng10(a7|a3,B)\ng11(divide|a2,A)\ng12(divide|a3,B)\ng13(divide|a2,B)\n"
    "g14(connect|a3)\ng15(grow|a4)\ng16(shrink|a6)\ng17(release|a5)\ng18(die|a6)\n"
    "g19(a4|a4)\ng20(a5|a5)\ng21(a7|a7)\ng22(connect|a7)\n";

inline Mesh scaled(Mesh mesh, double radius) {
  for (Point& v : mesh.vertices) v *= radius;
  return mesh;
}

inline Mesh cube() { return zoo::box({-0.55, -0.55, -0.55}, {0.55, 0.55, 0.55}); }

/// Returns DNA whose genes read substances that the simulator inserts.
inline Dna dnaThatSenses(const std::string& text, std::set<std::string> sensed) {
  DnaSurroundings around;
  around.sensed = std::move(sensed);
  return parseDna(text, "test.dna", 1, 1, "", &around);
}

inline Scene lineageOnly(const std::string& dna, std::uint64_t cycles) {
  Scene s;
  s.name = "lineage-only";
  s.seed = 1;
  s.dna = parseDna(dna, "test.dna");
  s.stop.cycles = cycles;
  return s;
}

/// Returns a scene of cells with bodies, without shell, contact and connections. The egg begins at rest.
inline Scene withBodies(const std::string& dna, std::uint64_t cycles,
                        const Mesh& egg = scaled(makeIcosphere(1), 0.95)) {
  Scene s = lineageOnly(dna, cycles);
  s.name = "with-bodies";
  MechanicsScene m;
  m.mesh = egg;
  m.physics.cell.mass = 1;
  m.physics.membrane = {10, 0.02, 1.26};
  m.physics.pressure = {200, 200 / measureVolume(egg.vertices, egg.faces)};
  m.division = {DivisionPlane::longest, {1, 0, 0}};
  s.mechanics = m;
  return s;
}

inline const ContactParameters pairContact{ContactLaw::pair, 30, 0.02, 0, 0.01, 1};
inline const ContactParameters pairContactWithViscosity{ContactLaw::pair, 30, 0.02, 0.3, 0.01, 1};
inline const ContactParameters thesisContact{ContactLaw::thesis, 30, 0.02, 0, 0.01, 1};

/// Returns a scene of sixteen cells that touch each other in a spherical shell.
inline Scene packed() {
  Scene s = withBodies(everybodyDivides, 5);
  s.name = "packed";
  s.mechanics->physics.shell = ShellParameters{{1, 1, 1}};
  s.mechanics->contact = pairContact;
  s.stop.time = 4.5;
  return s;
}

/// Returns a scene of eight cells in an ellipsoid, with viscosity, drag, random planes and sisters that stay connected.
inline Scene ellipsoid() {
  Scene s = withBodies(everybodyDivides, 3);
  s.name = "ellipsoid";
  s.mechanics->physics.shell = ShellParameters{{1.2, 1, 0.96}};
  s.mechanics->physics.drag = 0.5;
  s.mechanics->contact = pairContactWithViscosity;
  s.mechanics->division.otherwise.plane = DivisionPlane::random;
  s.mechanics->connections = ConnectionParameters{MakeConnections::atDivision, ConnectionsOnDivision::plane, 0.2, {}};
  s.stop.time = 3.5;
  s.stop.cycles.reset();
  return s;
}

/// Returns a scene with the thesis' integrator and contact law, a fixed time step and a fixed division axis.
inline Scene thesis() {
  Scene s = withBodies(uniqueFour, 4);
  s.name = "thesis";
  PhysicsParameters& p = s.mechanics->physics;
  p.integrator = Integrator::thesisVerlet;
  p.timeStep = 0x1p-7;
  p.pressure = {8, p.pressure.outside / 25};
  p.drag = 1;
  p.shell = ShellParameters{{1, 1, 1}};
  s.mechanics->contact = thesisContact;
  s.mechanics->division = {DivisionPlane::axis, {1, 2, 3}};
  return s;
}

/// Returns a scene to test lanes and slots. Cells are born, die, grow and connect by genes, and the number of cells
/// leaves some lanes of a block empty.
inline Scene life(const Mesh& egg = scaled(makeIcosphere(1), 0.95)) {
  Scene s = withBodies(eventful, 6, egg);
  s.name = "life";
  PhysicsParameters& p = s.mechanics->physics;
  p.drag = 0.3;
  p.growth = GrowthParameters{0.1};
  s.mechanics->contact = pairContactWithViscosity;
  s.mechanics->connections = ConnectionParameters{MakeConnections::both, ConnectionsOnDivision::both, 0.2, 1.6};
  return s;
}

// Variants of scenes: `life` from an egg with corners or with a hole, and any scene in another precision or by another
// method.
inline Scene lifeOfCubes() {
  Scene s = life(cube());
  s.name = "life-of-a-cube";
  return s;
}
inline Scene lifeOfRings() {
  Scene s = life(scaled(zoo::torus(7, 5), 0.33));
  s.name = "life-of-a-torus";
  s.mechanics->division = {DivisionPlane::axis, {1, 0, 0}};
  return s;
}
inline Scene inSingle(Scene s) {
  s.name += "-single";
  s.mechanics->physics.precision = Precision::binary32;
  return s;
}
inline Scene byPositions(Scene s, std::uint64_t substeps) {
  s.name += "-xpbd";
  s.mechanics->physics.integrator = Integrator::xpbd;
  s.mechanics->physics.substeps = substeps;
  return s;
}
inline Scene byShapes(Scene s) {
  s.name += "-shape-matching";
  s.mechanics->physics.cell.model = CellModel::shapeMatching;
  s.mechanics->physics.shapeMatching = {400, 0.5, 4};
  return s;
}

/// Returns a scene of sixteen spheres in a tight ellipsoid, with viscosity, drag and connections.
inline Scene spheres() {
  Scene s = withBodies(everybodyDivides, 5);
  s.name = "spheres";
  PhysicsParameters& p = s.mechanics->physics;
  p.cell = {0.9, 1, CellModel::sphere};
  p.timeStep = 0x1p-8;
  p.drag = 2;
  p.shell = ShellParameters{{1.2, 1, 0.96}};
  s.mechanics->contact = pairContactWithViscosity;
  s.mechanics->division.otherwise.plane = DivisionPlane::random;
  s.mechanics->connections = ConnectionParameters{MakeConnections::atDivision, ConnectionsOnDivision::plane, 0.2, 1.6};
  s.stop.time = 4.5;
  return s;
}

/// Returns `life` with cells that stick by substances, crawl, and connect by springs to cells they touch.
inline Scene sticky(const Mesh& egg = scaled(makeIcosphere(1), 0.95)) {
  Scene s = life(egg);
  s.name = "sticky";
  s.mechanics->contact->adhesion = AdhesionParameters{0.5, {{"a2", "a3", 2}, {"a4", "a*", 1}}};
  s.mechanics->physics.motility = MotilityParameters{0.2, 0.3};
  ConnectionParameters& c = *s.mechanics->connections;
  c.make = MakeConnections::byContact;
  c.onDivision = ConnectionsOnDivision::nearest;
  c.strength.reset();
  c.spring = ConnectionSpring{1, 0.9};
  c.releaseAge = 1.6;
  c.most = 3;
  return s;
}

/// Returns the scene with quasi-static growth, without time step and motility.
inline Scene settling(Scene s) {
  s.name += " settling";
  s.mechanics->physics.integrator = Integrator::quasiStatic;
  s.mechanics->physics.timeStep.reset();
  s.mechanics->physics.motility.reset();
  return s;
}

/// Returns a scene for hand-made cells: meshes of 162 vertices may touch meshes of 42.
inline Scene mixedMeshes() {
  Scene s = withBodies(uniqueFour, 1, makeIcosphere(2));
  s.name = "mixed-meshes";
  s.mechanics->coarser = {makeIcosphere(1)};
  s.mechanics->physics.coarsen = 1;
  s.mechanics->physics.drag = 2;
  s.mechanics->contact = pairContactWithViscosity;
  return s;
}

/// Returns five cells with two meshes, in contact, in a shell, and connected. Daughter A of the egg rests and keeps the
/// finer mesh; daughter B's descendants take the coarser one.
inline Scene coarsening() {
  Scene s = withBodies(
      "START: a0\n"
      "g1(a1|a0)\ng2(divide|a0)\ng3(a2|a1,A)\ng4(a3|a1,B)\ng5(divide|a1,B)\ng6(a4|a3)\ng7(divide|a3)\n"
      "g8(a2|a2)\ng9(a4|a4)\n",
      4, scaled(makeIcosphere(3), 0.95));
  s.name = "coarsening";
  MechanicsScene& m = *s.mechanics;
  m.coarser = {scaled(makeIcosphere(2), 0.95)};
  m.physics.coarsen = 0.2;
  m.physics.drag = 2;
  m.physics.shell = ShellParameters{{1.1, 1, 1}};
  m.contact = pairContactWithViscosity;
  m.connections = ConnectionParameters{MakeConnections::atDivision, ConnectionsOnDivision::plane, 0.2, {}};
  s.stop.time = 3.25;
  return s;
}

/// Returns a scene of four cells in contact. Daughters turn against each other, and polarities turn towards cells that
/// hold substance a2.
inline Scene turning() {
  Scene s = withBodies(uniqueFour, 4);
  s.name = "turning";
  MechanicsScene& m = *s.mechanics;
  m.physics.drag = 5;
  m.physics.shell = ShellParameters{{1.2, 1, 0.96}};
  m.contact = pairContactWithViscosity;
  m.division.otherwise = {.plane = DivisionPlane::polarity, .axis = {1, 2, 3}, .substance = "a2"};
  m.division.chirality = Chirality{-30, 0.3};
  s.stop.time = 3.25;
  s.stop.cycles.reset();
  return s;
}

/// Returns a scene of cells that grow in a shell and divide when they have added a given size. They do not divide while
/// they are surrounded or pressed, and do not grow while they are pressed.
inline Scene sensing() {
  Scene s = withBodies(everybodyDivides, 9);
  s.dna = dnaThatSenses("START: a0, grow\ng1(a0|a0)\ng2(divide|a0, !crowded, !pressed)\ng3(grow|a0, !pressed)\n",
                        {"crowded", "pressed"});
  s.name = "sensing";
  PhysicsParameters& p = s.mechanics->physics;
  p.drag = 1;
  p.growth = GrowthParameters{0.2, 1.2};
  p.shell = ShellParameters{{1.2, 1, 1}};
  s.mechanics->contact = pairContact;
  s.cycle.length = 0.5;
  s.cycle.divisionSize = DivisionSize{DivisionSize::Rule::adder, 0.05};
  SenseParameters crowded{"crowded", SenseKind::neighbours}, pressed{"pressed", SenseKind::volume};
  crowded.is = {.atLeast = 5, .until = 4};
  pressed.is = {.below = 0.8, .until = 0.95};
  s.senses = {crowded, pressed};
  s.stop.time = 4;
  s.stop.cycles.reset();
  return s;
}

/// Returns a scene of cells that divide by rules, with unequal shares, tilted planes, and a random cycle length
/// for each cell.
inline Scene varied() {
  Scene s = withBodies(uniqueFour, 4);
  s.name = "varied";
  s.seed = 5;
  s.cycle.length = 0.5;
  s.mechanics->physics.shell = ShellParameters{{1.2, 1.1, 1}};
  s.mechanics->physics.drag = 5;
  s.mechanics->contact = pairContact;
  s.mechanics->division.rules = {
      {.of = {"a1"}, .plane = {{DivisionPlane::axis, {-1, 0, 0.5}}}, .share = 0.6, .tilt = 15.0},
      {.of = {"a2", "divide"}, .plane = {{DivisionPlane::random}}}};
  s.variation = {.cycle = 0.1, .share = 0.04, .start = 0.05, .tilt = 8};
  return s;
}

}  // namespace morula::scenes
