// A shell given as a shape: its size, the egg in it, and the resolved form.
#include "base/maths.h"
#include "helpers.h"
#include "observation/measures.h"
#include "simulation/simulation.h"

using namespace morula;
using namespace morula::test;

namespace {

std::string sceneWith(const std::string& shell, const std::string& more = "cell: {radius: 1.5}", int level = 2) {
  return "morula: 1\nname: x\ndna: 'START: a0'\nstop: {time: 1}\nphysics:\n  mesh: {icosphere: " +
         std::to_string(level) + "}\n  " + more + "\n  shell: " + shell + "\n";
}

const double* axesOf(const Scenario& s) { return s.scene.mechanics->physics.shell->semiAxes.data(); }

double outermostOf(const Scenario& s) { return measureWorld(makeWorld(s.scene)).at("outermost"); }

}  // namespace

TEST_CASE("An ellipsoid with fill is a shape: the egg fills that share of it, and has its shape") {
  for (const auto& [level, fill] : {std::pair(0, 0.6), {1, 0.85}, {2, 0.92}, {3, 0.98}}) {
    const auto s =
        read(sceneWith("{ellipsoid: [27, 15, 11], fill: " + std::to_string(fill) + "}", "cell: {radius: 1.5}", level));
    const double* a = axesOf(s);
    CHECK(a[0] * a[1] * a[2] * fill == Approx(1.5 * 1.5 * 1.5).epsilon(1e-14));
    CHECK(a[0] / a[1] == Approx(27.0 / 15).epsilon(1e-14));
    CHECK(a[0] / a[2] == Approx(27.0 / 11).epsilon(1e-14));
    REQUIRE(s.scene.cells.size() == 1);
    const Vector stretch = s.scene.cells[0].stretch;
    CHECK(stretch.x * stretch.y * stretch.z == Approx(1).epsilon(1e-14));
    CHECK(stretch.x / stretch.z == Approx(27.0 / 11).epsilon(1e-14));

    const World world = makeWorld(s.scene);
    CHECK(world.cells.path == std::vector{CellPath()});
    CHECK(measureWorld(world).at("shell_fill") == Approx(fill).epsilon(1e-12));
    // The mesh's vertices lie farther out than a sphere of its volume, by this factor.
    const double vertexRadius = norm(s.scene.mechanics->mesh.vertices[0]) / 1.5;
    CHECK(outermostOf(s) < 1);
    // The shell holds the surface below the vertices, so its half-axes are longer by the sag.
    const double sag = world.bodies->sag[0];
    double outermost = 0;
    for (const Point& u : s.scene.mechanics->mesh.vertices) {
      const double x = u.x * a[0] / (a[0] + sag), y = u.y * a[1] / (a[1] + sag), z = u.z * a[2] / (a[2] + sag);
      outermost = std::max(outermost, norm(Point{x, y, z}) / norm(u));
    }
    CHECK(sag > 0);
    CHECK(outermostOf(s) == Approx(cubeRoot(fill) * vertexRadius * outermost).epsilon(1e-12));
  }
}

TEST_CASE("A sphere that fits: by fill alone, or beside any radius; the egg stays round") {
  for (const std::string shell : {"{fill: 0.5}", "{sphere: 7, fill: 0.5}", "{ellipsoid: [2, 2, 2], fill: 0.5}"}) {
    const auto s = read(sceneWith(shell));
    CHECK(axesOf(s)[0] == Approx(1.5 / cubeRoot(0.5)).epsilon(1e-15));
    CHECK(axesOf(s)[0] == axesOf(s)[2]);
    CHECK(s.scene.cells.empty());
  }
}

TEST_CASE("The resolved form says the sizes that hold, and gives the same scene again") {
  for (const std::string shell :
       {"{ellipsoid: [27, 15, 11], fill: 0.92}", "{fill: 0.3}", "{ellipsoid: [1, 2, 3], fill: 0.96}"}) {
    const auto s = read(sceneWith(shell));
    const auto again = read(s.resolved);
    CHECK(again.resolved == s.resolved);
    CHECK(again.meaning == s.meaning);
    CHECK(std::equal(axesOf(s), axesOf(s) + 3, axesOf(again)));
    CHECK(again.scene.cells.size() == s.scene.cells.size());
    for (std::size_t i = 0; i < s.scene.cells.size(); ++i)
      CHECK(again.scene.cells[i].stretch == s.scene.cells[i].stretch);
  }
  const auto eighth = read(sceneWith("{sphere: 9, fill: 0.125}", "cell: {radius: 2}")).resolved;
  CHECK_THAT(eighth, ContainsSubstring("\"fill\": 0.125") && ContainsSubstring("\"sphere\": 4"));
}

TEST_CASE("More than a mesh can fill of a shell of its shape is refused, with the most that it can") {
  // 12 vertices: an icosahedron, 0.6055 of its sphere; (5 (3 + √5) / 12) (4 sin 72°)^-3 · 8 over 4π/3
  CHECK_THAT(complaints(sceneWith("{ellipsoid: [3, 2, 1], fill: 0.61}", "cell: {radius: 2}", 0)),
             ContainsSubstring("physics.shell.fill: 0.61 is more than the egg's mesh can fill without standing out of "
                               "the shell; needs at most 0.605, or a finer physics.mesh"));
  CHECK_THAT(complaints(sceneWith("{fill: 0.61}", "cell: {radius: 2}", 0)), ContainsSubstring("at most 0.605"));
  CHECK(complaints(sceneWith("{fill: 0.605}", "cell: {radius: 2}", 0)).empty());
}

TEST_CASE("A shape means the same in any unit; fill counts for the meaning") {
  const auto meaning = [](const std::string& shell) { return read(sceneWith(shell)).meaning; };
  CHECK(meaning("{fill: 0.5}") == meaning("{sphere: 3, fill: 0.5}"));
  CHECK(meaning("{fill: 0.5}") != meaning("{fill: 0.25}"));
}

TEST_CASE("With cells at the start, and with cells as spheres, fill sizes the shell and stretches nobody") {
  const auto cells = read(sceneWith("{ellipsoid: [3, 2, 2], fill: 0.5}") + "cells: [{at: [0, 0, 0], scale: 0.5}]\n");
  CHECK(axesOf(cells)[0] / axesOf(cells)[1] == Approx(1.5));
  REQUIRE(cells.scene.cells.size() == 1);
  CHECK(cells.scene.cells[0].stretch == Vector{1, 1, 1});
  CHECK_THAT(cells.resolved, ContainsSubstring("\"cells\""));
  const std::string spheres =
      "morula: 1\nname: x\ndna: 'START: a0'\nstop: {time: 1}\nphysics: {time_step: 0.5, cell: {model: sphere}, shell: "
      "{ellipsoid: [3, 2, 2], fill: FILL}}\n";
  CHECK(read(replaced(spheres, "FILL", "0.5")).scene.cells.empty());
  CHECK_THAT(complaints(replaced(spheres, "FILL", "0.9")), ContainsSubstring("does not fit into the shell"));
}
