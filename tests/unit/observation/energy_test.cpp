// A closed scene conserves energy up to the time step's error of second order. Dissipated energy is accounted for, and
// space has no handedness.
#include "observation/energy.h"

#include "catch.h"
#include "unit/simulation/worlds.h"

using namespace morula;

namespace {

/// Returns a scene of cells without damping that stick with W = `work`.
Scene collision(double work, std::optional<double> timeStep = {}) {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(1));
  scene.mechanics->physics.membrane.damping = 0;
  scene.mechanics->physics.timeStep = timeStep;
  scene.mechanics->contact = ContactParameters{ContactLaw::pair, 30, 0};
  if (work > 0) scene.mechanics->contact->adhesion = AdhesionParameters{work, {}};
  return scene;
}

struct Course {
  double deviation;                  // [1] largest deviation, relative to the initial energy
  double contact = 0, adhesion = 0;  // [energy] maxima
  double shortest = 0;               // [time] smallest step
};

Course courseOf(const Scene& scene, int count, double speed) {
  World world = worldOf(scene, flyingCells(scene.mechanics->mesh, count, 2.62, speed));
  const double before = measureEnergy(world).total();
  Worst deviation, contact, adhesion;
  while (world.clock.time < 2.5) {
    step(world);
    if (world.clock.step % 4 != 0) continue;  // measuring costs more than a step
    const Energy e = measureEnergy(world);
    deviation.see(std::abs(e.total() - before) / before);
    contact.see(e.contact);
    adhesion.see(-e.adhesion);
  }
  double shortest = INFINITY;
  for (const auto& t : world.timeSteps) shortest = std::min(shortest, t.timeStep);
  return {deviation, contact, adhesion, shortest};
}

using Map = Vector (*)(const Vector&);

Vector rotated(const Vector& x) {  // half a turn about (1, 2, 2), then a third about (1, 1, 1): exact but for rounding
  const Vector axis = Vector{1, 2, 2} / 3.0, half = 2 * dot(axis, x) * axis - x;
  return {half.y, half.z, half.x};
}
Vector mirrored(const Vector& x) { return {x.y, x.x, x.z}; }

/// Returns the largest distance [length] between cells of a mapped world and mapped cells of the original, at the end.
double differenceUnder(Map map, bool turnsInsideOut, const ContactParameters& contact) {
  const auto endOf = [&](bool mapped) {
    Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(1));
    scene.mechanics->contact = contact;
    Mesh& mesh = scene.mechanics->mesh;
    std::vector<Body> cells = flyingCells(mesh, 3, 2.0, 1);
    if (mapped) {
      for (Point& x : mesh.vertices) x = map(x);
      if (turnsInsideOut) mesh = zoo::inverted(mesh);
      for (Body& cell : cells) {
        for (Point& x : cell.position) x = map(x);
        for (Vector& u : cell.velocity) u = map(u);
      }
    }
    World world = worldOf(scene, cells);
    runTo(world, 0.25);
    REQUIRE(world.contacts->list.pairs > 0);
    std::vector<Point> ends;
    for (int slot = 0; slot < 3; ++slot)
      for (const Point& x : takeBody(*world.bodies, slot).position) ends.push_back(x);
    return ends;
  };
  const std::vector<Point> one = endOf(false), other = endOf(true);
  Worst difference;
  for (std::size_t k = 0; k < one.size(); ++k) difference.see(norm(map(one[k]) - other[k]));
  return difference;
}

}  // namespace

TEST_CASE("Cells that collide without damping keep their energy, with the square of the step") {
  // The time between a meeting of vertices and the next step is chance, so ratios are averaged over collisions.
  double halved[2] = {1, 1};
  int collisions = 0;
  // Bounds for automatic steps: deviations are up to 8e-4, and 2.4e-3 for cells that stick and crumple.
  for (const auto& [work, bound] : {std::pair{0.0, 2e-3}, {1.0, 5e-3}})
    for (int count : {3, 4})
      for (double speed : {0.7, 0.85, 1.0}) {
        const Course automatic = courseOf(collision(work), count, speed);
        const auto with = [&](double share) {
          return courseOf(collision(work, share * automatic.shortest), count, speed);
        };
        const Course whole = with(1), half = with(0.5), quarter = with(0.25);
        CAPTURE(work, count, speed, automatic.deviation, whole.deviation, half.deviation, quarter.deviation);
        CHECK(automatic.contact > 0.03);
        CHECK((automatic.adhesion > 0.1) == (work > 0));
        CHECK(automatic.deviation <= bound);
        halved[0] *= whole.deviation / half.deviation;
        halved[1] *= half.deviation / quarter.deviation;
        ++collisions;
      }
  for (const double ratio : halved) {
    CAPTURE(std::pow(halved[0], 1.0 / collisions), std::pow(halved[1], 1.0 / collisions));
    CHECK(std::pow(ratio, 1.0 / collisions) >= 3);
    CHECK(std::pow(ratio, 1.0 / collisions) <= 5);
  }
}

TEST_CASE("What drag, damping and viscosity take is what is missing") {
  Scene scene = collision(1);
  scene.mechanics->physics.autoShare = 0.25;
  scene.mechanics->physics.membrane.damping = 0.05;
  scene.mechanics->physics.drag = 0.2;
  scene.mechanics->contact->damping = 0.2;
  scene.mechanics->contact->viscosity = 0.3;
  World world = worldOf(scene, flyingCells(scene.mechanics->mesh, 3, 2.3, 1));
  const double before = measureEnergy(world).total();
  double taken = 0, power = measureDissipation(world);
  Worst error;
  while (world.clock.time < 1) {
    step(world);
    const double now = measureDissipation(world);
    taken += 0.5 * (power + now) * world.clock.timeStep;
    power = now;
    error.see(std::abs(measureEnergy(world).total() + taken - before) / before);
  }
  CHECK(taken > 0.2 * before);
  CHECK(error < 2e-3);
}

TEST_CASE("A rotated and a mirrored copy end rotated and mirrored") {
  ContactParameters plain = scenes::pairContact, all = scenes::pairContactWithViscosity;
  all.adhesion = AdhesionParameters{1, {}};
  plain.law = all.law = ContactLaw::pair;
  for (const ContactParameters& contact : {plain, all}) {
    // Collisions amplify rounding, here to 1.0e-9.
    CHECK(differenceUnder(rotated, false, contact) < 1e-8);
    CHECK(differenceUnder(mirrored, true, contact) < 1e-8);
  }
}
