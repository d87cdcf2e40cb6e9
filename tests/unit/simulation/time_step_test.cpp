// The time step: the scene's own, checked against the limits, or the largest stable power of two.
#include "simulation/time_step.h"

#include "base/error.h"
#include "base/maths.h"
#include "base/number_text.h"
#include "catch.h"
#include "physics/stability.h"
#include "simulation/move_physics.h"
#include "worlds.h"

using namespace morula;

TEST_CASE("auto is a power of two that follows cells and how hard contacts are pressed, and each change is on record") {
  Scene scene = scenes::packed();
  scene.mechanics->contact->stiffness = 4;  // makes contacts deep
  World world = makeWorld(scene);
  REQUIRE(world.timeSteps.size() == 1);
  CHECK(world.timeSteps[0].time == 0);
  CHECK(world.timeSteps[0].step == 0);
  CHECK(world.timeSteps[0].timeStep == world.clock.timeStep);
  int hardened = 0, relaxed = 0;
  while (!finished(world)) {
    const double before = world.clock.timeStep, time = world.clock.time;
    const std::size_t cells = world.cells.path.size();
    const std::uint64_t epoch = world.clock.epochStep;
    step(world);
    CHECK(world.clock.time == time + before);  // dyadic steps add up exactly
    if (world.clock.timeStep == before) continue;
    if (world.cells.path.size() == cells) {
      const bool mayGrow = (world.clock.step - epoch) % 64 == 0;
      CHECK((mayGrow || (world.clock.timeStep < before && measureHardening(*world.contacts) > 24)));
      ++(world.clock.timeStep < before ? hardened : relaxed);
    }
    CHECK(world.timeSteps.back().time == world.clock.time);
    CHECK(world.timeSteps.back().step == world.clock.step);
    CHECK(world.timeSteps.back().timeStep == world.clock.timeStep);
  }
  CHECK(world.timeSteps.size() > 2);
  for (std::size_t i = 0; i < world.timeSteps.size(); ++i) {
    const double dt = world.timeSteps[i].timeStep;
    CHECK(powerOfTwoBelow(dt) == dt);
    if (i > 0) CHECK(dt != world.timeSteps[i - 1].timeStep);
  }
  CHECK(hardened > 0);
  CHECK(relaxed > 0);
  CHECK(world.timeSteps.back().timeStep < world.timeSteps[0].timeStep);  // smaller cells, shorter steps
}

TEST_CASE("A share of the automatic time step is taken at every change, and rounded down to a power of two") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 4);
  scene.mechanics->contact = scenes::pairContact;
  const World whole = makeWorld(scene);
  for (const double share : {0.5, 0.25, 0.3}) {
    scene.mechanics->physics.autoShare = share;
    World world = makeWorld(scene);
    while (!finished(world)) {
      CHECK(world.clock.timeStep == powerOfTwoBelow(share * timeStepLimit(world)));
      const std::size_t cells = world.cells.path.size();
      while (!finished(world) && world.cells.path.size() == cells) step(world);
    }
    CHECK(world.timeSteps.front().timeStep <= share * timeStepLimit(whole));
  }
}

TEST_CASE("Drag alone has a limit too: a cell in thick medium comes to rest, and no step oversteps it") {
  for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::thesisVerlet})
    for (const double drag : {200.0, 1e3, 1e6}) {
      Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1);
      scene.mechanics->physics.drag = drag;
      scene.mechanics->physics.integrator = integrator;
      scene.cells = {{.velocity = {1, 0, 0}, .stretch = {1.1, 1, 1}}};
      World world = makeWorld(scene);
      CHECK(world.clock.timeStep * drag <= 0.8 * (integrator == Integrator::velocityVerlet ? 1 : 2));
      for (int i = 0; i < 2000; ++i) step(world);
      CHECK(measureWorld(world).at("kinetic_energy") < 0.01);
      CHECK(std::abs(centreOf(world, "").x) < 2 / drag);
      scene.mechanics->physics.timeStep = 2.5 / drag;
      if (drag >= 1e3) CHECK_THROWS_WITH(makeWorld(scene), ContainsSubstring("of its drag"));
    }
}

TEST_CASE("A run that would never end is refused") {
  Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1);
  scene.cells = {{.scale = 1e-90}};
  CHECK_THROWS_WITH(makeWorld(scene),
                    ContainsSubstring("physics.time_step is") && ContainsSubstring("more than 1e+12 steps"));
  scene.cells = {};
  scene.mechanics->physics.timeStep = 1e-20;
  CHECK_THROWS_WITH(makeWorld(scene), ContainsSubstring("more than 1e+12 steps"));
}

TEST_CASE("A vertex that outruns its contacts ends the run, and the step that it is told to take serves") {
  Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1);
  scene.mechanics->contact = scenes::pairContact;
  scene.mechanics->contact->stiffness = 3;
  scene.cells = {{.at = {-1.5, 0, 0}, .velocity = {3000, 0, 0}}, {.at = {1.5, 0, 0}}};
  World world = makeWorld(scene);
  const auto failure = failureOf([&] {
    for (int i = 0; i < 5; ++i) step(world);
  });
  REQUIRE(failure);
  CHECK(failure->step == 1);
  CHECK(failure->cell == "A");
  CHECK_THAT(failure->quantity, ContainsSubstring("contacts reach"));
  const std::string lead = "physics.time_step: ";
  const double told = std::stod(failure->remedy.substr(failure->remedy.find(lead) + lead.size()));
  REQUIRE(told > 0);
  scene.mechanics->physics.timeStep = told;
  World again = makeWorld(scene);
  CHECK_NOTHROW(step(again));
  // Without contact, no vertex can outrun contacts.
  scene.mechanics->contact.reset();
  scene.mechanics->physics.timeStep.reset();
  World alone = makeWorld(scene);
  for (int i = 0; i < 5; ++i) CHECK_NOTHROW(step(alone));
}

TEST_CASE("Fast cells meet in shorter steps, and bounce; a fixed step that is too long for them is refused") {
  Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1);
  scene.mechanics->contact = scenes::pairContact;
  const double usual = makeWorld(scene).clock.timeStep;
  scene.cells = {{.at = {-3, 0, 0}, .velocity = {14, 0, 0}}, {.at = {3, 0.2, 0}, .velocity = {-14, 0, 0}}};
  World world = makeWorld(scene);
  CHECK(world.clock.timeStep < usual);
  CHECK(world.clock.timeStep * 14 <= 0.19 * world.contacts->radius[0]);
  CHECK(2 * world.clock.timeStep * 14 > 0.19 * world.contacts->radius[0]);
  runTo(world, 1);
  CHECK(centreOf(world, "A").x < 0);
  CHECK(centreOf(world, "B").x > 0);
  scene.mechanics->physics.timeStep = usual;
  CHECK_THROWS_WITH(makeWorld(scene), ContainsSubstring("of its contacts' reach in a time step of"));
  scene.cells = {scene.cells[0]};  // the cell has none to meet
  CHECK_NOTHROW(makeWorld(scene));
}

TEST_CASE("Cells that pass through each other end the run, and name each other; grazing ones fly on") {
  Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1);
  scene.mechanics->contact = scenes::pairContact;
  for (const auto& [speed, fixed] : {std::pair{30.0, 0.0}, {60.0, 0.0}, {30.0, 0x1p-12}}) {
    if (fixed > 0) scene.mechanics->physics.timeStep = fixed;  // a shorter step notices it, too
    scene.cells = {{.at = {-3, 0, 0}, .velocity = {speed, 0, 0}}, {.at = {3, 0.2, 0}, .velocity = {-speed, 0, 0}}};
    World world = makeWorld(scene);
    CAPTURE(speed, fixed);
    CHECK_THROWS_WITH(runTo(world, 1), ContainsSubstring("of its volume with cell") &&
                                           ContainsSubstring("they pass through each other") &&
                                           ContainsSubstring("physics.contact.stiffness"));
    CHECK(std::abs(centreOf(world, "A").x) < 1);  // the run ends while the cells overlap
  }
  scene.mechanics->physics.timeStep.reset();
  scene.cells = {{.at = {-3, 0, 0}, .velocity = {30, 0, 0}}, {.at = {3, 1.95, 0}, .velocity = {-30, 0, 0}}};
  World world = makeWorld(scene);
  runTo(world, 1);
  CHECK(centreOf(world, "A").x > 5);
}

TEST_CASE("A time step that is chosen twice in one step, for births and for contacts, is told once") {
  Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1);
  World world = makeWorld(scene);
  takeSteps(world, 3);
  for (const double share : {0.5, 0.25}) {
    world.bodies->parameters.autoShare = share;
    chooseTimeStep(world);
  }
  REQUIRE(world.timeSteps.size() == 2);
  CHECK(world.timeSteps[0].step == 0);
  CHECK(world.timeSteps[1].step == 3);
  CHECK(world.timeSteps[1].timeStep == world.clock.timeStep);
  CHECK(world.clock.timeStep == world.timeSteps[0].timeStep / 4);
}

TEST_CASE("When the small cells die the step may grow again") {
  const World world = ranToEnd(scenes::withBodies(
      "START: "
      "a0\ng1(divide|a0)\ng2(a1|a0)\ng3(a2|a1,A)\ng4(a3|a1,B)\ng5(divide|a2)\ng6(die|a3,A)\ng7(a3|a3)\ng8(a4|a2)\n"
      "g9(divide|a1,A)\ng10(divide|a2,A)\ng11(divide|a2,B)\ng12(die|a4)\n",
      9));
  bool grew = false;
  for (std::size_t i = 1; i < world.timeSteps.size(); ++i)
    grew = grew || world.timeSteps[i].timeStep > world.timeSteps[i - 1].timeStep;
  CHECK(grew);
}

TEST_CASE("A cell that shrinks gets lighter, and the step follows at its cell cycles") {
  for (double damping : {0.0, 0.02, 0.2}) {
    Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\ng2(shrink|a0)\n", 20);
    scene.mechanics->physics.growth = GrowthParameters{0.25};
    scene.mechanics->physics.drag = 1;
    scene.mechanics->physics.membrane.damping = damping;
    const World world = ranToEnd(scene);
    CHECK(world.bodies->mass(0) < 0.02);
    CHECK(world.timeSteps.size() > 2);
    for (const TimeStepChange& change : world.timeSteps) CHECK(change.time == std::floor(change.time));
    scene.mechanics->physics.timeStep = world.timeSteps[0].timeStep;
    CHECK_THROWS_WITH(ranToEnd(scene), ContainsSubstring("stability limit"));
  }
}

TEST_CASE("A fixed step is used as it is, and on record from the start") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 2);
  scene.mechanics->physics.timeStep = 0.001;
  World world = makeWorld(scene);
  CHECK(world.clock.timeStep == 0.001);
  REQUIRE(world.timeSteps.size() == 1);
  CHECK(world.timeSteps[0].timeStep == 0.001);
  for (int i = 0; i < 1500; ++i) step(world);
  CHECK(world.clock.time == Approx(1.5).epsilon(1e-15));  // the time is a product, not a sum of rounded steps
  CHECK(world.timeSteps.size() == 1);
  CHECK(world.cells.path.size() == 2);
}

TEST_CASE("An automatic step of 1 is on record like any other") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 2);
  PhysicsParameters& p = scene.mechanics->physics;
  p.membrane.stiffness = 1e-4;
  p.membrane.damping = 0;
  p.pressure = {1e-3, 1e-3 / 4};
  for (double mass : {0.001, 0.002, 0.004, 0.008, 0.016, 0.032, 0.064, 0.128}) {
    p.cell.mass = mass;
    const World world = makeWorld(scene);
    REQUIRE(world.timeSteps.size() == 1);
    CHECK(world.timeSteps[0].timeStep == world.clock.timeStep);
  }
}

TEST_CASE("A fixed step above a limit is the scene's mistake: the message names limit and remedy") {
  struct Case {
    const char* mode;
    double stiffness, gas, contact, timeStep;
  };
  for (const Case& c : {Case{"springs", 100, 1e-3, 0, 0.05}, Case{"pressure", 1e-3, 1000, 0, 0.05},
                        Case{"contacts", 1e-3, 1e-3, 1000, 0.01}}) {
    Scene scene = scenes::withBodies(scenes::uniqueFour, 3);
    PhysicsParameters& p = scene.mechanics->physics;
    p.membrane.stiffness = c.stiffness;
    p.membrane.damping = 0;
    p.pressure = {c.gas, c.gas / 4};
    if (c.contact > 0) scene.mechanics->contact = ContactParameters{ContactLaw::pair, c.contact, 0};
    p.timeStep = c.timeStep;
    CAPTURE(c.mode);
    try {
      makeWorld(scene);
      FAIL("it was accepted");
    } catch (const InputError& e) {
      const std::string text = e.what();
      CHECK_THAT(text, ContainsSubstring("physics.time_step " + exactText(c.timeStep)));
      CHECK_THAT(text, ContainsSubstring("stability limit"));
      CHECK_THAT(text, ContainsSubstring(std::string("of its ") + c.mode));
      CHECK_THAT(text, ContainsSubstring("auto"));
      const double fine = std::stod(text.substr(text.rfind("at most ") + 8));
      CHECK(fine > c.timeStep / 20);
      p.timeStep = fine;
      CHECK_NOTHROW(makeWorld(scene));
    }
  }
}

TEST_CASE("Explicit Euler without drag is refused, automatic or not, and the message says what to change") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 3);
  PhysicsParameters& p = scene.mechanics->physics;
  p.integrator = Integrator::explicitEuler;
  for (const std::optional<double> timeStep : {std::optional<double>(), std::optional(1e-6)}) {
    p.timeStep = timeStep;
    CHECK_THROWS_WITH(makeWorld(scene), ContainsSubstring("physics.integrator explicit-euler is stable with no") &&
                                            ContainsSubstring("physics.drag"));
  }
  p.timeStep.reset();
  p.drag = 5;
  CHECK_NOTHROW(makeWorld(scene));
}

TEST_CASE("Runge-Kutta takes longer steps than Verlet") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 3);
  scene.mechanics->physics.membrane.damping = 0;
  const double byVerlet = timeStepLimit(makeWorld(scene));
  scene.mechanics->physics.integrator = Integrator::rungeKutta4;
  CHECK(timeStepLimit(makeWorld(scene)) == Approx(std::sqrt(2.0) * byVerlet).epsilon(1e-12));
}

TEST_CASE("Limits far below 1 are named by digits, not by zeros") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 3);
  scene.mechanics->physics.cell.mass = 1e-14;
  scene.mechanics->physics.membrane.damping = 0;
  scene.mechanics->physics.timeStep = 1e-3;
  CHECK_THROWS_WITH(makeWorld(scene), !ContainsSubstring("0.000") && ContainsSubstring("e-"));
}

TEST_CASE("A fixed step that only the daughters do not bear stops the run at the division") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 9);
  const double first = makeWorld(scene).clock.timeStep;
  // A step just below the egg's limit is too long for the daughters, which are half as heavy.
  double dt = 2 * first;
  for (;; dt *= 0.95) {
    scene.mechanics->physics.timeStep = dt;
    try {
      makeWorld(scene);
      break;
    } catch (const InputError&) {}
  }
  World world = makeWorld(scene);
  const auto failure = failureOf([&] { runToEnd(world); });
  REQUIRE(failure);
  CHECK(failure->cell != "");
  CHECK(failure->step == world.clock.step);
  CHECK(world.cells.path.size() >= 2);
  CHECK_THAT(failure->what(), ContainsSubstring("stability limit"));
}

TEST_CASE("XPBD's automatic step goes by contacts alone, and without them there is none") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 3);
  PhysicsParameters& p = scene.mechanics->physics;
  p.integrator = Integrator::xpbd;
  CHECK_THROWS_WITH(makeWorld(scene),
                    ContainsSubstring("this scene has none") && ContainsSubstring("give physics.time_step a number"));
  p.timeStep = 1;  // every other integrator refuses this step
  CHECK_NOTHROW(makeWorld(scene));
  p.timeStep.reset();
  scene.mechanics->contact = scenes::thesisContact;
  CHECK_THROWS_WITH(makeWorld(scene), ContainsSubstring("this scene has none"));
  scene.mechanics->contact = scenes::pairContact;
  World world = makeWorld(scene);
  const double limit = contactLimit(Integrator::xpbd, scenes::pairContact.stiffness, scenes::pairContact.damping.constant,
                                    world.bodies->vertexMass[0]);
  CHECK(world.clock.timeStep == powerOfTwoBelow(0.8 * limit));
  runToEnd(world);
  CHECK(world.cells.path.size() == 8);
  p.timeStep = 0.9 * limit;
  CHECK_THROWS_WITH(makeWorld(scene), ContainsSubstring("of its contacts"));
}

TEST_CASE("With XPBD contacts gain no energy up to their limit, with sub-steps or without, and without much beyond") {
  const auto maxEnergy = [](std::uint64_t substeps, double damping, double times) -> double {
    Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1, makeIcosphere(2));
    scene.mechanics->physics.integrator = Integrator::xpbd;
    scene.mechanics->physics.substeps = substeps;
    scene.mechanics->contact = scenes::pairContact;
    scene.mechanics->contact->stiffness = 300;
    scene.mechanics->contact->damping = damping;
    scene.cells = {{.at = {-1.2, 0, 0}, .velocity = {1, 0, 0}}, {.at = {1.2, 0, 0}, .velocity = {-1, 0, 0}}};
    World world = makeWorld(scene);
    world.clock.timeStep = times * contactLimit(Integrator::xpbd, 300, damping, world.bodies->vertexMass[0]);
    Worst largest;
    while (world.clock.time < 1) {
      world.clock.time += world.clock.timeStep;
      try {
        movePhysics(world, world.clock.timeStep);
      } catch (const NumericalError&) {
        return INFINITY;  // movePhysics noticed the cells' excessive speed
      }
      largest.see(measureWorld(world).at("kinetic_energy"));
    }
    return largest;
  };
  for (const std::uint64_t substeps : {1, 2, 8})
    for (const double damping : {0.0, 0.02}) {
      CAPTURE(substeps, damping);
      CHECK(maxEnergy(substeps, damping, 0.95) < 1.01);               // the energy begins with 1
      if (substeps == 1) CHECK(maxEnergy(substeps, damping, 6) > 2);  // at a factor of 5 the energies are 1.9 and 5.3
    }
}
