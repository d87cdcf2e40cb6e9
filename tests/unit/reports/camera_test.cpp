#include "organism/camera.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "catch.h"
#include "pictures.h"

namespace morula {
namespace {

Vector direction(std::uint64_t seed, std::uint32_t i) { return randomDirection({seed, {}, i, Purpose::test}); }

Camera looking(Vector towardsEye, Vector up = {0, 0, 1}) { return {towardsEye, up, {}}; }

std::vector<Point> cloud(std::uint32_t number, Vector stretch) {
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < 100; ++i) {
    const Vector d = direction(number, i);
    points.push_back(Vector{d.x * stretch.x, d.y * stretch.y, d.z * stretch.z} + Vector{5, -3, 2});
  }
  return points;
}

/// Returns a point's place in the picture, −1 to 1 on both axes and in depth.
Vector project(const std::array<float, 16>& m, const Vector& p) {
  const auto row = [&](int i) { return m[i] * p.x + m[4 + i] * p.y + m[8 + i] * p.z + m[12 + i]; };
  return Vector{row(0), row(1), row(2)} / row(3);
}

}  // namespace

TEST_CASE("the eye's axes are a right-handed frame", "[camera]") {
  for (std::uint32_t i = 0; i < 50; ++i) {
    const Camera camera = looking(direction(1, i) * 3.0, direction(2, i) * 0.2);
    const EyeAxes axes = eyeAxes(camera);
    REQUIRE(norm(axes.x) == Approx(1));
    REQUIRE(norm(axes.y) == Approx(1));
    REQUIRE(norm(axes.z * 3.0 - camera.towardsEye) == Approx(0).margin(1e-12));
    REQUIRE(norm(cross(axes.x, axes.y) - axes.z) == Approx(0).margin(1e-12));
    REQUIRE(dot(axes.x, camera.up) == Approx(0).margin(1e-12));
    REQUIRE(dot(axes.y, camera.up) > 0);
  }
}

TEST_CASE("a camera without a direction is refused", "[camera]") {
  REQUIRE_THROWS_AS(eyeAxes(looking({0, 0, 0})), InputError);
  REQUIRE_THROWS_AS(eyeAxes(looking({0, 0, 2}, {0, 0, -1})), InputError);
  REQUIRE_THROWS_AS(eyeAxes(looking({0, 1, 0}, {0, 0, 0})), InputError);
  REQUIRE_THROWS_AS(eyeAxes(looking({0, NAN, 0})), InputError);
}

TEST_CASE("a fitted frame holds every point and wastes no room", "[camera]") {
  for (const auto& [w, h] : {std::pair{900, 900}, {1200, 700}, {300, 900}})
    for (std::uint32_t i = 0; i < 10; ++i) {
      const EyeAxes axes = eyeAxes(looking(direction(3, i)));
      const Aperture aperture = apertureOf(w, h);
      const std::vector<Point> points = cloud(i, {2, 1, 0.5});
      const Framing framing = frame(points, axes, aperture);
      const auto matrix = projection(aperture, framing.distance, 0.1 * framing.distance, 3 * framing.distance);
      double farthest = 0;
      for (const Point& p : points) {
        const Vector seen = project(matrix, axes.of(p - framing.centre));
        farthest = std::max({farthest, std::abs(seen.x), std::abs(seen.y)});
        REQUIRE(std::abs(seen.z) < 1);
      }
      REQUIRE(farthest < 0.96);
      REQUIRE(farthest > 0.88);
    }
}

TEST_CASE("nearer points have smaller depths, from -1 at the near plane to 1 at the far one", "[camera]") {
  const auto matrix = projection({0.2, 0.2}, 10, 2, 30);
  REQUIRE(project(matrix, {0, 0, 8}).z == Approx(-1).margin(1e-5));
  REQUIRE(project(matrix, {0, 0, -20}).z == Approx(1).margin(1e-5));
  REQUIRE(project(matrix, {0, 0, 1}).z < project(matrix, {0, 0, 0}).z);
  REQUIRE(project(matrix, {2, 0, 0}).x == Approx(1));  // aperture 0.2 at distance 10
  REQUIRE(project(matrix, {0, 1, 5}).y == Approx(1));  // aperture 0.2 at distance 5
}

TEST_CASE("nothing to see gives a frame all the same", "[camera]") {
  REQUIRE(frame({}, eyeAxes({}), apertureOf(9, 9)).distance == 1);
  REQUIRE(frame({{1, 2, 3}}, eyeAxes({}), apertureOf(9, 9)).distance == 1);
}

TEST_CASE("named views look along the axes, with z up or y up", "[views]") {
  const auto axes = [](const char* view) { return eyeAxes(parseView(view)); };
  const auto are = [&](const char* view, Vector right, Vector up) {
    CAPTURE(view);
    const EyeAxes eye = axes(view);
    CHECK(norm(eye.x - right) < 1e-15);
    CHECK(norm(eye.y - up) < 1e-15);
  };
  are("front", {1, 0, 0}, {0, 0, 1});
  are("back", {-1, 0, 0}, {0, 0, 1});
  are("right", {0, 1, 0}, {0, 0, 1});
  are("left", {0, -1, 0}, {0, 0, 1});
  are("top", {1, 0, 0}, {0, 1, 0});
  are("bottom", {1, 0, 0}, {0, -1, 0});
  are("90,0", {0, 1, 0}, {0, 0, 1});
  // All three axes look equally long from the corner of a cube.
  const EyeAxes iso = axes("iso");
  for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}})
    CHECK(std::hypot(dot(axis, iso.x), dot(axis, iso.y)) == Approx(std::sqrt(2.0 / 3)));
  for (const char* wrong : {"", "Front", "10", "10,", "10,91", "1e999,0", "10,20,30", "nan,0"}) {
    CAPTURE(wrong);
    CHECK_THROWS_WITH(parseView(wrong), ContainsSubstring("front, back, left"));
  }
}

TEST_CASE("what stands on the right is seen from the right", "[views]") {
  OrganismPicture p = picture({ball("A", {1.2, 0, 0}, 0.6, red), ball("B", {-1.2, 0, 0}, 0.6, blue)});
  p.camera = parseView("right");
  p.camera.framing = Framing{{0, 0, 0}, 10};
  CHECK(isReddish(centre(drawOrganism(p))));
  p.camera = parseView("left");
  p.camera.framing = Framing{{0, 0, 0}, 10};
  CHECK(isBluish(centre(drawOrganism(p))));
}

TEST_CASE("a turntable goes around once and keeps the organism whole", "[views]") {
  OrganismPicture p = picture({ball("A", {2, 0, 0}, 0.5, red), ball("B", {-1, 0, 0}, 0.5, blue)});
  p.camera = parseView("front");
  const auto turns = turntable(p, 4);
  REQUIRE(turns.size() == 4);
  CHECK(norm(turns[1].towardsEye - Vector{1, 0, 0}) < 1e-15);
  CHECK(norm(turns[2].towardsEye - Vector{0, 1, 0}) < 1e-15);
  for (const Camera& turn : turns) {
    CHECK(turn.framing->distance == turns[0].framing->distance);
    CHECK(turn.framing->centre == turns[0].framing->centre);
    p.camera = turn;
    REQUIRE_FALSE(touchesEdges(drawOrganism(p)));
  }
}

}  // namespace morula
