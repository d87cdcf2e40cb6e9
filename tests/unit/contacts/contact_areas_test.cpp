// Contact areas: which cells touch, and over which area.
#include <map>
#include <numbers>

#include "catch.h"
#include "pair_oracle.h"

using namespace morula;

namespace {

/// Returns the contact areas. `outside`: pressure added on both sides of the membranes, so that gas keeps its volume.
std::vector<ContactArea> areas(const std::vector<Body>& cells, const Mesh& mesh, double outside = 0) {
  PhysicsParameters p = limp();
  p.pressure.outside = outside;
  Crowd crowd(p, {}, mesh, cells);
  return measureContactAreas(crowd.contacts, crowd.lab.bodies);
}

}  // namespace

TEST_CASE("Balls side by side touch, balls apart do not") {
  const Mesh ball = makeIcosphere(2);
  CHECK(areas({ballAt(ball, {})}, ball).empty());
  CHECK(areas({ballAt(ball, {}), ballAt(ball, {2.2, 0, 0})}, ball).empty());
  const auto touching = areas({ballAt(ball, {}), ballAt(ball, {1.9, 0, 0})}, ball);
  REQUIRE(touching.size() == 1);
  CHECK(touching[0].a == 0);
  CHECK(touching[0].b == 1);
}

TEST_CASE("Two balls cut flat that press each other touch over force over pressure: over the disc of the cut") {
  for (int level : {2, 3, 4}) {
    const Mesh ball = makeIcosphere(level);
    const double reach = meanEdge(ball);
    for (double height : {0.8, 0.6, 0.4}) {  // height of the cutting plane over the centre
      // Slightly more than pairs on the sharp rim overlap by themselves, so that the rim does not bear the rest.
      const double overlap = 0.25 * reach + 2 * surfaceDepth * measureSag(ball);  // surfaces overlap by 0.25 reach
      Body left = ballAt(ball, {}), right = ballAt(ball, {2 * height, 0, 0});
      for (Point& x : left.position) x.x = std::min(x.x, height);
      for (Point& x : right.position) x.x = std::max(x.x, height) - overlap;
      const Crowd limpOnes = evaluated({limp(), {}, ball, {left, right}});
      const double force = limpOnes.lab.forceOn(1).x, disc = std::numbers::pi * (1 - height * height);
      const double pressure = force / disc, outside = 1e5 * pressure;
      const auto areaAt = [&](double share) {  // share of `pressure`
        for (Body* b : {&left, &right})
          b->pressureConstant = (outside + share * pressure) * measureVolume(b->position, ball.faces);
        const auto pairs = areas({left, right}, ball, outside);
        REQUIRE(pairs.size() == 1);
        return pairs[0].area;
      };
      CAPTURE(level, height, disc, pressure);
      // Tilted pairs on the rim bear sideways, up to 7.2 %, 3.7 % and 2.7 % of the discs' forces.
      const double tilted = level == 2 ? 0.08 : level == 3 ? 0.04 : 0.03;
      CHECK(areaAt(1) == Approx(disc).epsilon(tilted));
      CHECK(areaAt(2) == Approx(disc / 2).epsilon(tilted));
      // However small the pressure, the area is at most twice the area of the pressed vertices.
      const double rim = std::sqrt(1 - height * height) + 1.5 * reach;
      CHECK(areaAt(1e-6) < 2 * std::numbers::pi * rim * rim);
      CHECK(areaAt(1e-6) > 1.5 * disc);
    }
  }
}

TEST_CASE("A row of balls touches pair by pair, in order, whatever the slots") {
  const Mesh ball = makeIcosphere(2);
  std::vector<Body> row;
  for (int i = 0; i < 10; ++i) row.push_back(ballAt(ball, {1.9 * i, 0, 0}));
  const auto pairs = areas(row, ball);
  REQUIRE(pairs.size() == 9);
  for (int i = 0; i < 9; ++i) {
    CHECK(pairs[i].a == i);
    CHECK(pairs[i].b == i + 1);
    CHECK(pairs[i].area > 0);
  }
}

TEST_CASE("Areas do not depend on when the list was built") {
  Crowd crowd(limp(), {}, ball, heap(ball, 9, 1.8, 1));
  crowd.step(0x1p-8);
  const auto lazy = measureContactAreas(crowd.contacts, crowd.lab.bodies);
  crowd.contacts.listIsValid = false;
  refreshList(crowd.contacts, crowd.lab.bodies, 1);
  const auto fresh = measureContactAreas(crowd.contacts, crowd.lab.bodies);
  REQUIRE(lazy.size() == fresh.size());
  CHECK(lazy.size() > 5);
  for (std::size_t i = 0; i < lazy.size(); ++i) {
    CHECK(lazy[i].a == fresh[i].a);
    CHECK(lazy[i].b == fresh[i].b);
    CHECK(lazy[i].area == fresh[i].area);
  }
}

namespace {

/// Returns the areas by definition. A vertex counts its force over pressure, up to twice its area. Adhesion averages
/// this with the share of W that it holds, with the weights pressure and 3 W/A. A pair of cells counts at most twice
/// its pressed area, and nothing below 0.005 of the smaller cell's surface.
std::map<std::pair<int, int>, double> bruteForce(const Bodies& b, const ContactParameters& law) {
  std::map<std::pair<int, int>, double> areas, pressed;
  ContactParameters still = law;
  still.damping = still.viscosity = 0;
  const PairOracle oracle(b, still);
  for (const SeenVertex& i : oracle.all) {
    double around = 0;
    for (const auto& [v, j, k] : oracle.rings.faces[i.v])
      around += norm(cross(b.vertex(i.slot, j) - b.vertex(i.slot, v), b.vertex(i.slot, k) - b.vertex(i.slot, v))) / 6;
    for (int other = 0; other < b.count; ++other) {
      double pressing = 0, held = 0;
      for (const SeenVertex& j : oracle.all) {
        const Vector h = (j.normal - i.normal) / 2.0;
        const Vector a = i.x - j.x;
        if (law.adhesion && j.slot == other && other != i.slot) held += oracle.crowdingBy(i, j).held;
        if (j.slot == other && other != i.slot && dot(a, h) < 0 && PairOracle::kappa(i, j) * dot(a, a) < 1)
          pressing += std::max(0.0, dot(oracle.pushOf(i, j).force, h) / norm(h));
      }
      const double least = law.stiffness / 5000 / std::sqrt(i.inverseRadiusSquared) / around;
      const double pressure = std::max((b.pressure[i.slot] + b.pressure[other]) / 2, least);
      double area = std::min(pressing / pressure, 2 * around);
      pressed[std::minmax(i.slot, other)] += area / 2;
      if (law.adhesion && other != i.slot) {
        const double cover = 2 * held * around / (law.adhesion->strength * std::pow(oracle.restArea(i.slot), 2));
        const double kappa = PairOracle::kappa(i, oracle.all[other * b.vertexCount()]);
        const double stress = 3 * law.adhesion->strength * std::sqrt(kappa) / 1.5;
        area = (pressure * area + stress * around * std::clamp((cover - 0.1) / 0.9, 0.0, 1.0)) / (pressure + stress);
      }
      areas[std::minmax(i.slot, other)] += area / 2;
    }
  }
  for (auto& [pair, area] : areas) area = std::min(area, 2 * pressed[pair]);
  std::erase_if(areas, [&](const auto& pair) {
    const double radius =
        b.parameters.cell.radius * std::min(b.restScale[pair.first.first], b.restScale[pair.first.second]);
    return pair.second < 0.005 * 4 * std::numbers::pi * radius * radius;
  });
  return areas;
}

}  // namespace

TEST_CASE("Areas are those of the definition, vertex by vertex, with viscosity and adhesion too") {
  const Mesh ball = makeIcosphere(2);
  int pairs = 0;
  ContactParameters plain{}, sticky{ContactLaw::pair, 40, 0.05, 0.3};
  sticky.adhesion = AdhesionParameters{2, {}};
  for (const ContactParameters& law : {plain, sticky})
    for (std::uint32_t key = 0; key < 4; ++key) {
      auto cells = heap(ball, 9, 1.85, 0, key);
      for (std::size_t c = 0; c < cells.size(); ++c) cells[c].pressureConstant = 0.5 * static_cast<double>(c % 3);
      Crowd crowd(limp(), law, ball, cells);
      const auto expected = bruteForce(crowd.lab.bodies, law);
      const auto areas = measureContactAreas(crowd.contacts, crowd.lab.bodies);
      REQUIRE(areas.size() == expected.size());
      for (const ContactArea& p : areas) {
        REQUIRE(expected.contains({p.a, p.b}));
        CHECK(p.area == Approx(expected.at({p.a, p.b})).epsilon(1e-5));
        ++pairs;
      }
    }
  CHECK(pairs > 60);
}
