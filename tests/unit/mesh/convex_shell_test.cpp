// Convex shells: their planes, and what is none.
#include "mesh/convex_shell.h"

#include "catch.h"
#include "mesh/obj_source.h"
#include "zoo.h"

using namespace morula;

namespace {

std::string complaint(const std::string& text) {
  try {
    readConvexShell(text, "egg.obj");
    return "";
  } catch (const InputError& error) { return error.what(); }
}

}  // namespace

TEST_CASE("A box has six planes, of twelve triangles, where its file has them") {
  const ConvexShell shell = readConvexShell(zoo::objOf(zoo::box({-1, -2, -3}, {4, 5, 6})), "egg.obj");
  CHECK(shell.mesh.vertices[0] == Point{-1, -2, -3});
  const std::vector<ShellPlane> planes{{{0, 0, -1}, 3}, {{0, 0, 1}, 6},  {{0, -1, 0}, 2},
                                       {{0, 1, 0}, 5},  {{-1, 0, 0}, 1}, {{1, 0, 0}, 4}};
  CHECK(shell.planes == planes);
  CHECK(measureReach(shell.planes, {2, 0, 0}) == 0.5);
  CHECK(measureReach(shell.planes, {-2, 2.5, 3}) == 2);
  CHECK(nearestPlane(shell.planes, {3.5, 4, 5}).normal == Vector{1, 0, 0});
  CHECK(nearestPlane(shell.planes, {0, 0, 0}).normal == Vector{-1, 0, 0});
}

TEST_CASE("A shell twice as large has its planes twice as far out") {
  const ConvexShell shell = scaleConvexShell(readConvexShell(zoo::objOf(zoo::tetrahedron()), "egg.obj"), 2);
  REQUIRE(shell.planes.size() == 4);
  for (const ShellPlane& plane : shell.planes) {
    CHECK(norm(plane.normal) == Approx(1).epsilon(1e-15));
    CHECK(plane.offset == Approx(2 / std::sqrt(3.0)).epsilon(1e-15));
  }
  CHECK(measureVolume(shell.mesh.vertices, shell.mesh.faces) == Approx(8 * 8 / 3.0));
}

TEST_CASE("Every triangle of an icosphere is a plane of its own, and its vertices lie on it") {
  const ConvexShell shell = readConvexShell(zoo::objOf(makeIcosphere(2)), "egg.obj");
  CHECK(shell.planes.size() == 320);
  for (const Point& x : shell.mesh.vertices) CHECK(measureReach(shell.planes, x) == Approx(1).epsilon(1e-8));
}

TEST_CASE("What is no shell is refused with the face, its line and the reason") {
  Mesh dented = zoo::box({-1, -1, -1}, {1, 1, 1});
  dented.vertices[7] = {0.5, 0.5, 0.5};
  CHECK_THAT(complaint(zoo::objOf(dented)),
             ContainsSubstring("egg.obj:") && ContainsSubstring("lies outside of its plane; a shell is convex"));
  CHECK_THAT(complaint(zoo::objOf(zoo::torus(7, 5))), ContainsSubstring("egg.obj:"));
  CHECK_THAT(complaint(zoo::objOf(zoo::box({1, -1, -1}, {3, 1, 1}))),
             ContainsSubstring("egg.obj:17:1: face 9: the origin is not inside of this face"));
  CHECK_THAT(complaint(zoo::objOf(zoo::box({-0.001, -2, -2}, {3, 2, 2}))), ContainsSubstring("almost in this face"));
  Mesh inverted = zoo::box({-1, -1, -1}, {1, 1, 1});
  for (Face& f : inverted.faces) std::swap(f[0], f[1]);
  CHECK_FALSE(complaint(zoo::objOf(inverted)).empty());
  Mesh open = zoo::box({-1, -1, -1}, {1, 1, 1});
  open.faces.pop_back();
  CHECK_FALSE(complaint(zoo::objOf(open)).empty());
  CHECK_THAT(complaint(zoo::objOf(zoo::box({-1e7, -1e7, -1e7}, {1e7, 1e7, 1e7}))), ContainsSubstring("more than 1e6"));
  CHECK(complaint(zoo::objOf(zoo::box({-1, -1, -1}, {1, 1, 1}))).empty());
}
