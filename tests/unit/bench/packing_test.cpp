// Packed cells: their start, and that they fill their shell.
#include "bench/packed_world.h"

#include "base/random.h"
#include "bench/subject.h"
#include "catch.h"
#include "observation/measures.h"
#include "temporary_folder.h"

using namespace morula;

namespace {

bool same(const std::vector<Body>& a, const std::vector<Body>& b) {
  return std::ranges::equal(a, b, [](const Body& x, const Body& y) {
    return std::tie(x.position, x.velocity, x.mass, x.restScale, x.pressureConstant) ==
           std::tie(y.position, y.velocity, y.mass, y.restScale, y.pressureConstant);
  });
}

/// Moves points apart as pushApart does, over all pairs.
void pushAllApart(std::vector<Point>& points, double distance, double radius) {
  std::vector<Vector> move(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const Vector d = points[j] - points[i];
      const double square = dot(d, d);
      if (square >= distance * distance || square == 0) continue;
      const Vector push = (0.25 * (distance / std::sqrt(square) - 1)) * d;
      move[i] -= push;
      move[j] += push;
    }
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] += move[i];
    if (const double r = norm(points[i]); r > radius) points[i] = (radius / r) * points[i];
  }
}

std::vector<Body> someBodies() {
  Body a{{{1, 2, 3}, {-0.0, 1e-310, 1.0 / 3}}, {{4, 5, 6}, {7, 8, 9}}, 0.1, 0.2, 0.3}, b = a;
  b.position[1].z = 17;
  return {a, b};
}

}  // namespace

TEST_CASE("Cells begin apart from each other, inside the ball, in order of their paths") {
  for (const int count : {1, 2, 3, 8, 37, 100}) {
    CAPTURE(count);
    const auto cells = packBall(count);
    REQUIRE(static_cast<int>(cells.size()) == count);
    double nearest = 10;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      CHECK(norm(cells[i].centre) <= 1 - 0.74 * shareRadius(count));
      if (i > 0) CHECK(cells[i - 1].path < cells[i].path);
      for (std::size_t j = 0; j < i; ++j) {
        CHECK_FALSE(cells[j].path.isAncestorOf(cells[i].path));
        nearest = std::min(nearest, norm(cells[i].centre - cells[j].centre));
      }
    }
    if (count > 1) CHECK(nearest > shareRadius(count));
  }
}

TEST_CASE("Points are pushed apart as by a loop over all pairs, to the bit, wherever they lie") {
  for (const std::uint32_t count : {1u, 2u, 64u, 500u}) {
    CAPTURE(count);
    const double distance = 1.7 * shareRadius(static_cast<int>(count)), radius = 1 - 0.75 * shareRadius(count);
    std::vector<Point> points;
    for (std::uint32_t i = 0; i < count; ++i)  // also on the ball's surface, and one at another's place
      points.push_back((i % 5 == 0 ? 1 : 0.2 * (i % 5)) * randomDirection({1, {}, i % 499, Purpose::test}));
    std::vector<Point> expected = points;
    for (int round = 0; round < 8; ++round) {
      pushApart(points, distance, radius);
      pushAllApart(expected, distance, radius);
      REQUIRE(points == expected);
    }
  }
}

TEST_CASE("Cells of neighbouring paths lie near each other, as sisters do") {
  const auto cells = packBall(64);
  double sisters = 0, any = 0;
  for (std::size_t i = 0; i < 64; ++i) {
    sisters += norm(cells[i].centre - cells[i ^ 1].centre) / 64;
    any += norm(cells[i].centre - cells[(i + 29) % 64].centre) / 64;
  }
  CHECK(sisters < 0.6 * any);
}

TEST_CASE("Packed cells fill their shell and stay in it") {
  const World world = makePackedWorld({.cells = 8});
  const WorldMeasures m = measureWorld(world);
  CHECK(m.at("cells") == 8);
  CHECK(m.at("shell_fill") >= 0.85);
  CHECK(m.at("shell_fill") <= 1);
  CHECK(m.at("outermost") <= 1 + 1e-12);
  for (const CellMeasures& cell : measureCells(world)) CHECK(cell.at("neighbours") >= 3);
}

TEST_CASE("What was packed once is found again, bit by bit") {
  const TemporaryFolder folder;
  int packings = 0;
  const auto count = [&](const std::string&) { ++packings; };
  const auto first = settledBodies({.cells = 2, .level = 1}, folder.path(), count);
  CHECK(packings == 1);
  CHECK(same(settledBodies({.cells = 2, .level = 1}, folder.path(), count), first));
  CHECK(packings == 1);
  // Another viscosity uses the same packing, another mesh does not.
  CHECK(same(settledBodies({.cells = 2, .level = 1, .viscosity = 0.3}, folder.path(), count), first));
  CHECK(packings == 1);
  CHECK_FALSE(same(settledBodies({.cells = 2, .level = 2}, folder.path(), count), first));
  CHECK(packings == 2);
  CHECK(same(settledBodies({.cells = 2, .level = 1}, "", count), first));
  CHECK(packings == 3);
}

TEST_CASE("A file of bodies gives back what it was given, and nothing when it is not whole") {
  const TemporaryFolder folder;
  const auto file = folder / "new/some.bodies";
  const Hash key{1, 2};
  CHECK_FALSE(readBodies(file, key));
  writeBodies(file, key, someBodies());
  REQUIRE(readBodies(file, key));
  CHECK(same(*readBodies(file, key), someBodies()));
  CHECK_FALSE(readBodies(file, Hash{1, 3}));

  const auto isRefused = [&](const std::string& text) {
    writeText(file, text);
    return !readBodies(file, key);
  };
  const std::string bytes = readText(file);
  for (std::size_t length = 0; length < bytes.size(); length += 13) CHECK(isRefused(bytes.substr(0, length)));
  for (std::size_t at = 0; at < bytes.size(); at += 7) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x40);
    CHECK(isRefused(changed));
  }
  CHECK(isRefused(bytes + "x"));
}

TEST_CASE("A file that cannot be written is an error") {
  CHECK_THROWS_AS(writeBodies("/proc/none/some.bodies", {}, someBodies()), FileError);
}

TEST_CASE("Stirred cells move as fast as is said, each its own way, the same every time") {
  World a = makePackedWorld({.cells = 8, .level = 1}), b = makePackedWorld({.cells = 8, .level = 1});
  stir(a);
  stir(b);
  CHECK(a.bodies->velocity == b.bodies->velocity);
  double squares = 0;
  Vector mean;
  const int vertices = 8 * a.bodies->vertexCount();
  for (int slot = 0; slot < 8; ++slot)
    for (int v = 0; v < a.bodies->vertexCount(); ++v) {
      const Vector w = a.bodies->read(a.bodies->velocity, slot, v);
      squares += dot(w, w);
      mean += w / vertices;
    }
  const double speed = std::sqrt(squares / vertices);
  const double edge = a.bodies->mesh.meanRestLength * a.bodies->restScale[0];
  CHECK(speed * a.clock.timeStep == Approx(stirredMove * edge).epsilon(1e-12));
  CHECK(norm(mean) < 0.7 * speed);
}
