// Convex shells: their planes, and meshes that are refused.
#include "mesh/convex_shell.h"

#include <cstdio>

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

namespace {

/// Returns a sphere of quads of radius 2 with rounded decimals; `dent` pushes a vertex on the equator inwards.
std::string sphereOfQuads(int decimals, double dent = 0) {
  constexpr int around = 32, down = 16;
  std::string text, faces;
  char line[100];
  const auto vertex = [&](double x, double y, double z) {
    std::snprintf(line, sizeof line, "v %.*f %.*f %.*f\n", decimals, x, decimals, y, decimals, z);
    text += line;
  };
  const auto at = [&](int i, int j) { return std::to_string(2 + (i - 1) * around + j % around); };
  vertex(0, 0, 2);
  for (int i = 1; i < down; ++i)
    for (int j = 0; j < around; ++j) {
      const double t = 3.14159265358979 * i / down, p = 2 * 3.14159265358979 * j / around;
      const double r = 2 * (i == 8 && j == 3 ? 1 - dent : 1);
      vertex(r * std::sin(t) * std::cos(p), r * std::sin(t) * std::sin(p), r * std::cos(t));
    }
  vertex(0, 0, -2);
  const std::string last = std::to_string(2 + (down - 1) * around);
  for (int j = 0; j < around; ++j) faces += "f 1 " + at(1, j) + " " + at(1, j + 1) + "\n";
  for (int i = 1; i < down - 1; ++i)
    for (int j = 0; j < around; ++j)
      faces += "f " + at(i, j) + " " + at(i + 1, j) + " " + at(i + 1, j + 1) + " " + at(i, j + 1) + "\n";
  for (int j = 0; j < around; ++j) faces += "f " + at(down - 1, j) + " " + last + " " + at(down - 1, j + 1) + "\n";
  return text + faces;
}

}  // namespace

TEST_CASE("A shell of quads is convex as far as the digits of its file tell") {
  for (const int decimals : {4, 5, 6, 9}) {
    CAPTURE(decimals);
    const ConvexShell shell = readConvexShell(sphereOfQuads(decimals), "s.obj");
    // Each quad is one plane, unless the planes of both of its triangles hold all vertices to 1e-9 as written.
    if (decimals < 9) CHECK(shell.planes.size() == 14 * 32 + 2 * 32);
    for (const Point& x : shell.mesh.vertices)
      CHECK(measureReach(shell.planes, x) <= 1 + 1e-9);  // the tolerance of all shells
  }
  for (const int decimals : {4, 6, 9})
    CHECK_THAT(complaint(sphereOfQuads(decimals, 0.05)),
               ContainsSubstring("lies outside of its plane; a shell is convex"));
}

TEST_CASE("The rounding of a coordinate follows from the digits of its file") {
  WrittenDigits fixed;
  for (const char* number : {"1.234567", "-12.5", "0"}) fixed.note(number);
  CHECK(fixed.roundingOf(1.2) == Approx(5e-7));
  CHECK(fixed.roundingOf(0) == Approx(5e-7));
  WrittenDigits significant;  // six digits per number
  for (const char* number : {"123.456", "0.00123456", "1e-3"}) significant.note(number);
  CHECK(significant.roundingOf(123.4) == Approx(5e-4));
  CHECK(significant.roundingOf(0.00123) == Approx(5e-9));
  WrittenDigits exponents;
  exponents.note("-1.234567e-02");
  CHECK(exponents.roundingOf(-0.01234567) == Approx(5e-9));
}
