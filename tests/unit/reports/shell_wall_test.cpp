// Cells that press against their shell are drawn inside of its wall, without patches that come out of it.
#include "organism/shell_wall.h"

#include "catch.h"
#include "organism/surface.h"
#include "pictures.h"

namespace morula {
namespace {

const std::vector<ShellPlane> cube{{{1, 0, 0}, 1},  {{-1, 0, 0}, 1}, {{0, 1, 0}, 1},
                                   {{0, -1, 0}, 1}, {{0, 0, 1}, 1},  {{0, 0, -1}, 1}};

CellShape coarseBall(double radius, Colour colour) {
  const Mesh mesh = makeIcosphere(1);
  CellShape cell{.path = "A", .vertices = {}, .colour = colour, .faces = mesh.faces};
  for (const Point& p : mesh.vertices) cell.vertices.push_back(p * radius);
  return cell;
}

/// Returns a ball that fills most of the cube: its vertices lie in it, and many in its sides.
CellShape pressedBall(Colour colour) {
  CellShape cell = coarseBall(1.2, colour);
  for (Point& p : cell.vertices)
    p = {std::clamp(p.x, -1.0, 1.0), std::clamp(p.y, -1.0, 1.0), std::clamp(p.z, -1.0, 1.0)};
  return cell;
}

/// Returns the cube's wall as a translucent cell with sharp edges.
CellShape cubeWall(double size, Colour colour, double opacity) {
  CellShape wall{.path = "shell", .vertices = {}, .colour = colour, .opacity = opacity, .isWall = true};
  for (const ShellPlane& side : cube) {
    const Vector n = side.normal, u{n.y, n.z, n.x}, v = cross(n, u);
    const int first = int(wall.vertices.size());
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      wall.vertices.push_back((n + u * a + v * b) * size);
    wall.faces.push_back({first, first + 1, first + 2});
    wall.faces.push_back({first, first + 2, first + 3});
  }
  return wall;
}

/// Returns the drawn surface's points in space.
std::vector<Point> pointsOf(const OrganismPicture& picture) {
  const EyeAxes axes = eyeAxes(picture.camera);
  std::vector<Point> points;
  for (const SurfaceVertex& v : makeSurface(picture, axes, *picture.camera.framing).vertices)
    points.push_back(picture.camera.framing->centre + axes.x * v.position[0] + axes.y * v.position[1] +
                     axes.z * v.position[2]);
  return points;
}

double reachOf(const OrganismPicture& picture, const Point& p) {
  if (picture.shell) return norm(Vector{p.x / picture.shell->x, p.y / picture.shell->y, p.z / picture.shell->z});
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});  // in the cube
}

}  // namespace

TEST_CASE("A cell that its shell holds is drawn half a gap inside of the wall, and unchanged where it is", "[shell]") {
  OrganismPicture round = picture({coarseBall(1, red)}), box = picture({pressedBall(red)});
  for (Point& p : round.cells[0].vertices) p = {2 * p.x * 1.05, p.y * 1.05, 0.7 * p.z * 1.05};
  round.shell = Vector{2, 1, 0.7}, box.shellPlanes = cube;
  for (OrganismPicture held : {round, box}) {
    held.camera = {.towardsEye = {0.3, -1, 0.4}, .up = {0, 0, 1}, .framing = Framing{{0.2, -0.1, 0.3}, 10}};
    OrganismPicture free = held;
    free.shell.reset(), free.shellPlanes.clear();
    const std::vector<Point> inside = pointsOf(held), before = pointsOf(free);
    REQUIRE(inside.size() == before.size());
    int moved = 0;
    for (std::size_t i = 0; i < inside.size(); ++i) {
      const double reach = reachOf(held, before[i]);
      CHECK(reachOf(held, inside[i]) == Approx(std::min(reach, 1.01)).epsilon(1e-6));
      if (reach > 1.0101) {
        ++moved;
        CHECK(norm(cross(inside[i], before[i])) < 1e-6);  // towards the middle
      } else if (reach < 1.0099) {
        CHECK(inside[i] == before[i]);
      }
    }
    CHECK(moved > 20);
  }
}

TEST_CASE("Cells that stand out of the shell are drawn as they are", "[shell]") {
  for (const double far : {1.15, 2.5}) {  // half of the ball, or all of it, is outside
    OrganismPicture p = picture({ball("A", {far, 0, 0}, 0.3, red)});
    const std::vector<Point> before = pointsOf(p);
    p.shell = Vector{1, 1, 1};
    CHECK(pointsOf(p) == before);
    p.shell.reset(), p.shellPlanes = cube;
    CHECK(pointsOf(p) == before);
  }
}

TEST_CASE("No part of a cell that presses against a shell comes out of the wall", "[shell]") {
  const auto within = [](const Image& image, double radius, auto isBare) {
    int bare = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        if (std::hypot(x - 0.5 * image.width, y - 0.5 * image.height) < radius && isBare(image.at(x, y))) ++bare;
    return bare;
  };
  const double unit = 300 / 3.8;  // [pixel] of a length in the middle
  // Black is black only where no glass is before it. From 1.035 on, bent faces of 42 vertices cross the old wall.
  OrganismPicture round = picture({coarseBall(1.035, {0, 0, 0})}, 300);
  round.shell = Vector{1, 1, 1};
  CHECK(within(drawOrganism(round), 0.8 * unit, [](Colour c) { return c.b < 20; }) == 0);
  // The wall's red lies over all of the black cell.
  OrganismPicture box = picture({pressedBall({0, 0, 0}), cubeWall(shellThickness, red, 0.5)}, 300);
  box.shellPlanes = cube;
  CHECK(within(drawOrganism(box), 0.8 * unit, [](Colour c) { return c.r < 60; }) == 0);
}

}  // namespace morula
