// Chirality: newborn daughters turn against each other about the division axis.
#include "simulation/swirls.h"

#include <numbers>

#include "catch.h"
#include "observation/body_measures.h"
#include "worlds.h"

using namespace morula;

namespace {

/// Returns a scene of one cell that divides once, along `axis`, at time 1, without contact.
Scene pair(const Vector& axis, std::optional<Chirality> chirality, double drag = 100) {
  Scene s = scenes::withBodies("START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(a1|a1)\n", 9);
  s.mechanics->physics.drag = drag;
  s.mechanics->division.otherwise = {.plane = DivisionPlane::axis, .axis = axis};
  s.mechanics->division.chirality = chirality;
  s.cycle.perSubstance["a1"] = 100;
  s.stop.cycles.reset();
  s.stop.time = 2.8;
  return s;
}

/// Returns the angle about `axis` [degree] that turns the first cell best onto the second, both about their centres. It
/// is positive if clockwise seen along the axis.
double turnOf(const World& from, const World& to, const char* path, Vector axis) {
  axis = axis / norm(axis);
  const auto placesOf = [&](const World& world) {
    std::vector<Point> x = cellVertices(world, CellPath::parse(path));
    const Point centre = measureCentroid(x);
    for (Point& p : x) p -= centre;
    return x;
  };
  const std::vector<Point> p = placesOf(from), q = placesOf(to);
  double sine = 0, cosine = 0;
  for (std::size_t v = 0; v < p.size(); ++v) {
    sine += dot(axis, cross(p[v], q[v]));
    cosine += dot(p[v], q[v]) - dot(p[v], axis) * dot(q[v], axis);
  }
  return std::atan2(sine, cosine) * (180 / std::numbers::pi);
}

const Vector oblique{1, 2, -2};

}  // namespace

TEST_CASE(
    "chirality: in a thick medium free daughters turn by the angle, A clockwise along the axis and B against it") {
  const World still = ranToEnd(pair(oblique, {}));
  for (const double angle : {20.0, -45.0}) {
    const World turned = ranToEnd(pair(oblique, Chirality{angle, 0.2}));
    CHECK(turned.clock.step == still.clock.step);
    CHECK(turnOf(still, turned, "A", oblique) == Approx(angle).epsilon(0.01));
    CHECK(turnOf(still, turned, "B", oblique) == Approx(-angle).epsilon(0.01));
  }
}

TEST_CASE("chirality: after one time constant 1/e of the angle is left") {
  Scene scene = pair(oblique, Chirality{60, 0.4});
  scene.stop.time = 1.4;
  Scene unturned = pair(oblique, {});
  unturned.stop.time = 1.4;
  const double turned = turnOf(ranToEnd(unturned), ranToEnd(scene), "A", oblique);
  CHECK(turned == Approx(60 * (1 - std::exp(-1.0))).epsilon(0.05));  // the medium takes a moment to take the cell along
}

TEST_CASE("chirality: the other sign of the axis is the same hand, for it exchanges the daughters") {
  const World still = ranToEnd(pair(oblique, {})), turned = ranToEnd(pair(-oblique, Chirality{20, 0.2}));
  // With −oblique, daughter B lies where `oblique` points.
  CHECK(turnOf(ranToEnd(pair(-oblique, {})), turned, "B", oblique) == Approx(20).epsilon(0.01));
  CHECK(turnOf(ranToEnd(pair(-oblique, {})), turned, "A", oblique) == Approx(-20).epsilon(0.01));
}

TEST_CASE("chirality: the mirrored angle gives the mirrored scene, with contact, too") {
  const auto mirrored = [](Vector x) { return Vector{x.x, -x.y, x.z}; };
  const auto contact = [](Scene s) {
    s.mechanics->contact = scenes::pairContactWithViscosity;
    s.stop.time = 1.5;
    return s;
  };
  const World world = ranToEnd(contact(pair(oblique, Chirality{40, 0.2}, 10)));
  Scene image = contact(pair(mirrored(oblique), Chirality{-40, 0.2}, 10));
  for (Point& x : image.mechanics->mesh.vertices) x = mirrored(x);
  for (Face& f : image.mechanics->mesh.faces) std::swap(f[1], f[2]);
  const World other = ranToEnd(image);
  double turned = 0;
  for (const char* path : {"A", "B"}) {
    const auto x = cellVertices(world, CellPath::parse(path)), y = cellVertices(other, CellPath::parse(path));
    for (std::size_t v = 0; v < x.size(); ++v) CHECK(norm(mirrored(x[v]) - y[v]) < 1e-7);
    turned += std::abs(turnOf(ranToEnd(contact(pair(oblique, {}, 10))), world, path, oblique));
  }
  CHECK(turned > 20);
}

TEST_CASE("chirality: momentum and centres stay as they are without it") {
  Scene swirling = pair(oblique, Chirality{90, 0.2}), still = pair(oblique, {});
  World a = makeWorld(swirling), b = makeWorld(still);
  while (!finished(a)) {
    step(a);
    step(b);
    REQUIRE(norm(measureMomentum(*a.bodies) - measureMomentum(*b.bodies)) < 1e-12);
    for (int slot : a.bodies->slots)
      REQUIRE(norm(measureCentre(*a.bodies, slot) - measureCentre(*b.bodies, slot)) < 2e-3);
  }
}

TEST_CASE("chirality: of the division's rule alone, and for eight time constants") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 4);
  scene.mechanics->physics.drag = 5;
  scene.mechanics->division.rules = {DivisionRule{.of = {"a3"}, .chirality = Chirality{20, 0.05}}};
  World world = makeWorld(scene);
  const auto youngOnes = [&] {
    std::vector<std::string> paths;
    findSwirls(world);
    for (const Swirl& swirl : *world.swirls) paths.push_back(world.cells.path[swirl.cell].text());
    return paths;
  };
  runTo(world, 1.5);
  CHECK(youngOnes().empty());  // the egg's division has no rule
  while (world.cells.path.size() < 4) step(world);
  CHECK(youngOnes() == std::vector<std::string>{"BA", "BB"});
  const std::vector<Swirl> swirls = *world.swirls;
  CHECK(swirls[0].rate == Approx(20 * std::numbers::pi / 180 / 0.05));
  CHECK(swirls[1].rate == -swirls[0].rate);
  CHECK(swirls[0].axis == world.divisions.back().axis);
  const double born = world.clock.time;
  runTo(world, born + 0.39);
  CHECK(youngOnes().size() == 2);
  runTo(world, born + 0.41);
  CHECK(youngOnes().empty());
}

TEST_CASE("chirality: a scene without it has no swirls") { CHECK_FALSE(ranToEnd(pair(oblique, {})).swirls); }
