#include "organism/surface.h"

#include "catch.h"
#include "pictures.h"

namespace morula {
namespace {

Surface surfaceOf(const OrganismPicture& picture) {
  return makeSurface(picture, eyeAxes(picture.camera), *picture.camera.framing);
}

double distanceFromAxis(const SurfaceVertex& v) {
  const Vector p{v.position[0], v.position[1], v.position[2]};
  return norm(p);
}

}  // namespace

TEST_CASE("normals of a sphere point outward", "[surface]") {
  const Mesh sphere = makeIcosphere(2);
  const std::vector<Vector> normals = vertexNormals(sphere.vertices, sphere.faces);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    REQUIRE(norm(normals[i]) == Approx(1));
    REQUIRE(dot(normals[i], sphere.vertices[i]) == Approx(1));
  }
}

TEST_CASE("a coarse sphere is drawn round", "[surface]") {
  const Surface surface = surfaceOf(picture({ball("", {0, 0, 0}, 1, red)}));
  const std::size_t faces = makeIcosphere(2).faces.size();
  REQUIRE(surface.corners.size() == faces * 16 * 3);
  REQUIRE(surface.solid == surface.corners.size());
  // Vertices of flat faces would lie up to 1.6 % inside of the sphere.
  for (const SurfaceVertex& v : surface.vertices) REQUIRE(distanceFromAxis(v) == Approx(1).margin(0.0006));
}

TEST_CASE("the mesh's own vertices stay where they are", "[surface]") {
  const Surface surface = surfaceOf(picture({ball("", {0, 0, 0}, 1, red)}));
  int corners = 0;
  for (const SurfaceVertex& v : surface.vertices)
    if (v.corner[0] == 1 || v.corner[1] == 1 || v.corner[2] == 1) {
      REQUIRE(distanceFromAxis(v) == Approx(1).margin(1e-6));
      ++corners;
    }
  REQUIRE(corners == 3 * 320);
}

TEST_CASE("split faces keep their winding and cover the face", "[surface]") {
  const Surface surface = surfaceOf(picture({ball("", {0, 0, 0}, 1, red)}));
  double area = 0;
  for (std::size_t i = 0; i < surface.corners.size(); i += 3) {
    Vector p[3];
    for (int k = 0; k < 3; ++k) {
      const float* q = surface.vertices[surface.corners[i + k]].position;
      p[k] = {q[0], q[1], q[2]};
    }
    const Vector twice = cross(p[1] - p[0], p[2] - p[0]);
    REQUIRE(dot(twice, p[0]) > 0);
    area += 0.5 * norm(twice);
  }
  REQUIRE(area == Approx(4 * 3.14159265).epsilon(0.003));
}

TEST_CASE("many cells are split less, solid cells come first, invisible ones not at all", "[surface]") {
  std::vector<CellShape> cells;
  for (int i = 0; i < 400; ++i) cells.push_back(ball("A", {0, 0, 0}, 1, red));
  cells[0].opacity = 0.5;
  cells[1].opacity = 0;
  const Surface surface = surfaceOf(picture(cells));
  REQUIRE(surface.solid == 398u * 320 * 3);
  REQUIRE(surface.corners.size() == 399u * 320 * 3);
  REQUIRE(surface.vertices.front().owner == 3);
  REQUIRE(surface.vertices.back().owner == 1);
}

}  // namespace morula
