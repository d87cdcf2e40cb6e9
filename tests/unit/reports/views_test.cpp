
#include <cmath>

#include "base/error.h"
#include "catch.h"
#include "organism/camera.h"
#include "pictures.h"

namespace morula {

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
  // From the corner of a cube all three axes are seen equally long.
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
    const Image image = drawOrganism(p);
    for (int i = 0; i < image.width; ++i) {
      REQUIRE(image.at(i, 0) == paper);
      REQUIRE(image.at(i, image.height - 1) == paper);
      REQUIRE(image.at(0, i) == paper);
      REQUIRE(image.at(image.width - 1, i) == paper);
    }
  }
}

}  // namespace morula
