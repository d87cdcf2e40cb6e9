// A part that a scene does not name does not exist: no structure, no search, no rows.
#include "catch.h"
#include "simulation/move_physics.h"
#include "unit/simulation/worlds.h"

using namespace morula;

TEST_CASE("A lineage-only scene has no bodies and nothing that goes with them") {
  World world = makeWorld(scenes::lineageOnly(scenes::uniqueFour, 3));
  CHECK_FALSE(world.bodies);
  CHECK_FALSE(world.contacts);
  CHECK_FALSE(world.connections);
  CHECK(world.divisionPolicy == nullptr);
  CHECK(world.timeSteps.empty());
  runToEnd(world);
  CHECK(world.cells.path.size() == 4);
  CHECK(world.clock.timeStep == 0);
  CHECK(measureCells(world).empty());
  CHECK(measureContacts(world).empty());
  CHECK(cellVertices(world, CellPath::parse("AA")).empty());
  CHECK_FALSE(measureWorld(world)["volume"]);
}

TEST_CASE("Without a contact block cells pass through each other and no neighbour structure is built") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(1));
  const auto cells = flyingCells(makeIcosphere(1), 2, 2.5, 1);
  World without = worldOf(scene, cells);
  CHECK_FALSE(without.contacts);
  CHECK_FALSE(without.connections);
  scene.mechanics->contact = scenes::pairContact;
  World with = worldOf(scene, cells);
  REQUIRE(with.contacts);
  CHECK(with.contacts->rows.size() > 0);
  const Vector apart = centreOf(without, "B") - centreOf(without, "A");
  runTo(without, 3);
  runTo(with, 3);
  CHECK(dot(centreOf(without, "B") - centreOf(without, "A"), apart) < 0);
  CHECK(dot(centreOf(with, "B") - centreOf(with, "A"), apart) > 0);
  CHECK(measureContacts(without).empty());
  CHECK(measureCells(without)[0].at("neighbours") == 0);
}

TEST_CASE("A scene without drag, damping or shell calls no kernel for them") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1);
  const World plain = makeWorld(scene);
  const PhysicsKernels& k = physicsKernels(plain.execution.isa);
  CHECK(plain.stages.drift == k.driftVelocityVerlet[int(ShellShape::none)]);
  CHECK(plain.stages.kick == k.kickVelocityVerlet[false]);
  CHECK(plain.stages.finishForces == k.addPressureForces);
  CHECK(plain.stages.findTensions == k.findWeightedTensions[true]);
  scene.mechanics->physics.membrane.damping = 0;
  scene.mechanics->physics.drag = 1;
  scene.mechanics->physics.membrane.springs = Springs::equal;
  scene.mechanics->physics.shell = ShellParameters{{1, 1, 1}, {}, Held::vertices};
  const World other = makeWorld(scene);
  CHECK(other.stages.findTensions == k.findTensions);
  CHECK(other.stages.finishForces == k.addPressureAndDragForces);
  CHECK(other.stages.drift == k.driftVelocityVerlet[int(ShellShape::sphere)]);
  CHECK(other.stages.kick == k.kickVelocityVerlet[true]);
  scene.mechanics->physics.shell = ShellParameters{{1, 1, 1.5}, {}, Held::vertices};
  CHECK(makeWorld(scene).stages.drift == k.driftVelocityVerlet[int(ShellShape::ellipsoid)]);
  scene.mechanics->physics.shell->holds = Held::surface;
  CHECK(makeWorld(scene).stages.drift == k.driftVelocityVerlet[int(ShellShape::surface)]);
}

TEST_CASE("Contact of a cell that is alone changes nothing") {
  Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1);
  World without = makeWorld(scene, {Isa::scalar, 1});
  scene.mechanics->contact = scenes::pairContactWithViscosity;
  World with = makeWorld(scene, {Isa::scalar, 1});
  for (int i = 0; i < 100; ++i) {
    without.bodies->velocity[0] += 0.01;
    with.bodies->velocity[0] += 0.01;
    // The time steps would differ: contact has a limit of its own. Both worlds take the same one.
    movePhysics(without, 0x1p-8);
    movePhysics(with, 0x1p-8);
  }
  CHECK(with.bodies->position == without.bodies->position);
  CHECK(with.contacts->list.pairs == 0);
}

TEST_CASE("A block with few cells takes the narrowest kernels that hold them, and never wider ones than asked for") {
  for (const Precision precision : {Precision::binary64, Precision::binary32}) {
    const bool wide = precision == Precision::binary64;
    CHECK(narrowestIsa(1, Isa::avx512, precision) == Isa::scalar);
    CHECK(narrowestIsa(2, Isa::avx512, precision) == Isa::narrow);
    CHECK(narrowestIsa(3, Isa::avx512, precision) == (wide ? Isa::avx2 : Isa::narrow));
    CHECK(narrowestIsa(5, Isa::avx512, precision) == (wide ? Isa::avx512 : Isa::avx2));
    CHECK(narrowestIsa(8, Isa::avx2, precision) == Isa::avx2);
    CHECK(narrowestIsa(8, Isa::narrow, precision) == Isa::narrow);
    CHECK(narrowestIsa(8, Isa::scalar, precision) == Isa::scalar);
  }
  const World world = makeWorld(scenes::packed());
  CHECK(world.stagesOfLanes[0].drift == physicsKernels(Isa::scalar).driftVelocityVerlet[int(ShellShape::surface)]);
  CHECK(world.stagesOfLanes[7].drift == world.stages.drift);
}
