// Who touches whom, and over which area.
#include <map>
#include <numbers>

#include "catch.h"
#include "crowd.h"

using namespace morula;

namespace {

std::vector<ContactArea> areas(const std::vector<Body>& cells, const Mesh& mesh) {
  Crowd crowd(limp(), {}, mesh, cells);
  return measureContactAreas(crowd.contacts, crowd.lab.bodies);
}

Body at(const Mesh& mesh, const Vector& place) { return shakenBody(zoo::moved(mesh, place), 0, 0); }

}  // namespace

TEST_CASE("Balls side by side touch, balls apart do not") {
  const Mesh ball = makeIcosphere(2);
  CHECK(areas({at(ball, {})}, ball).empty());
  CHECK(areas({at(ball, {}), at(ball, {2.2, 0, 0})}, ball).empty());
  const auto touching = areas({at(ball, {}), at(ball, {1.9, 0, 0})}, ball);
  REQUIRE(touching.size() == 1);
  CHECK(touching[0].a == 0);
  CHECK(touching[0].b == 1);
}

TEST_CASE("Two balls cut flat against each other touch over the disc of the cut and little more") {
  for (int level : {2, 3, 4}) {
    const Mesh ball = makeIcosphere(level);
    const double reach = makeBodies({}, ball, 1).mesh.meanRestLength;
    for (double height : {0.8, 0.6, 0.4}) {  // of the plane over the centre
      Body left = at(ball, {}), right = at(ball, {2 * height, 0, 0});
      for (Point& x : left.position) x.x = std::min(x.x, height);
      for (Point& x : right.position) x.x = std::max(x.x, height);
      const auto pairs = areas({left, right}, ball);
      REQUIRE(pairs.size() == 1);
      const double disc = std::numbers::pi * (1 - height * height);
      // Around the disc, the gap is below a quarter of the reach; and there are the faces on the rim.
      const double rim = std::sqrt(1 - (height - reach / 8) * (height - reach / 8)) + reach;
      CAPTURE(level, height);
      CHECK(pairs[0].area > 0.9 * disc);
      CHECK(pairs[0].area < std::numbers::pi * rim * rim);
    }
  }
}

TEST_CASE("A row of balls touches pair by pair, in order, whatever the slots") {
  const Mesh ball = makeIcosphere(2);
  std::vector<Body> row;
  for (int i = 0; i < 10; ++i) row.push_back(at(ball, {1.9 * i, 0, 0}));
  const auto pairs = areas(row, ball);
  REQUIRE(pairs.size() == 9);
  for (int i = 0; i < 9; ++i) {
    CHECK(pairs[i].a == i);
    CHECK(pairs[i].b == i + 1);
    CHECK(pairs[i].area > 0);
  }
}

TEST_CASE("Areas do not depend on when the list was built") {
  const Mesh ball = makeIcosphere(1);
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

/// The same by the definition alone: every vertex against every vertex of every other cell.
std::map<std::pair<int, int>, double> bruteForce(const Bodies& b, const ContactParameters& c) {
  std::map<std::pair<int, int>, double> areas;
  const std::vector<SeenVertex> all = seen(b, c);
  for (const SeenVertex& i : all) {
    double nearest = INFINITY;
    int touched = -1;
    for (const SeenVertex& j : all) {
      const Vector apart = i.x - j.x, facing = j.normal - i.normal;
      const double reach = std::sqrt(2 / (i.inverseRadiusSquared + j.inverseRadiusSquared));
      const bool touches = j.slot != i.slot && norm(apart) < reach && dot(i.normal, j.normal) < 0 &&
                           dot(apart, facing / norm(facing)) <= reach / 4;
      if (touches && norm(apart) < nearest) nearest = norm(apart), touched = j.slot;
    }
    if (touched < 0) continue;
    double around = 0;
    for (const Face& f : b.mesh.mesh.faces)
      if (f[0] == i.v || f[1] == i.v || f[2] == i.v)
        around += norm(cross(b.vertex(i.slot, f[1]) - b.vertex(i.slot, f[0]),
                             b.vertex(i.slot, f[2]) - b.vertex(i.slot, f[0]))) /
                  2;
    areas[std::minmax(i.slot, touched)] += around / 3 / 2;  // its third, of the mean of two sides
  }
  return areas;
}

}  // namespace

TEST_CASE("Areas are those of the definition, vertex against vertex, whatever the law") {
  const Mesh ball = makeIcosphere(2);
  int pairs = 0;
  for (const ContactLaw law : {ContactLaw::pair, ContactLaw::thesis})
    for (std::uint32_t key = 0; key < 4; ++key) {
      ContactParameters parameters;
      parameters.law = law;
      Crowd crowd(limp(), parameters, ball, heap(ball, 9, 1.85, 0, key));
      const auto expected = bruteForce(crowd.lab.bodies, parameters);
      const auto areas = measureContactAreas(crowd.contacts, crowd.lab.bodies);
      REQUIRE(areas.size() == expected.size());
      for (const ContactArea& p : areas) {
        REQUIRE(expected.contains({p.a, p.b}));
        CHECK(p.area == Approx(expected.at({p.a, p.b})).epsilon(1e-12));
        ++pairs;
      }
    }
  CHECK(pairs > 80);
}
