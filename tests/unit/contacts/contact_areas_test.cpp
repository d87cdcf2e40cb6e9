// Who touches whom, and over which area.
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
