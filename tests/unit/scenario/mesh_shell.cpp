// A shell that is a mesh in a file: how it is read, its size, and parts that exclude it.
#include "helpers.h"
#include "observation/measures.h"
#include "simulation/simulation.h"

using namespace morula;
using namespace morula::test;

namespace {

const std::string cube =
    "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

std::string sceneInShell(const std::string& shell, const std::string& more = "cell: {radius: 0.9}") {
  return "morula: 1\nname: x\ndna: 'START: a0'\nstop: {time: 1}\nphysics:\n  " + more + "\n  shell: " + shell + "\n";
}

Scenario readWith(const std::string& text, const std::string& obj = cube) {
  return readScenario(text, "test.yaml", "", {}, {{"shell", "egg.obj", obj}});
}

std::string complaintsOf(const std::string& text, const std::string& obj = cube) {
  return refusalOf([&] { readWith(text, obj); });
}

const ConvexShell& shellOf(const Scenario& s) { return *s.scene.mechanics->physics.shell->mesh; }

}  // namespace

TEST_CASE("A shell's mesh is taken as it is, and stored with the scenario") {
  const Scenario s = readWith(sceneInShell("{mesh: egg.obj}"));
  CHECK(shellOf(s).planes.size() == 6);
  CHECK(shellOf(s).mesh.vertices[7] == Point{1, 1, 1});
  REQUIRE(s.files.size() == 1);
  CHECK(s.files[0].role == "shell");
  CHECK_THAT(s.resolved, ContainsSubstring("\"mesh\": \"egg.obj\"") && !ContainsSubstring("\"sphere\""));
  const Scenario again = readWith(s.resolved);
  CHECK(again.resolved == s.resolved);
  CHECK(again.meaning == s.meaning);
  const auto start = measureWorld(makeWorld(s.scene));
  CHECK(start.at("shell_fill") == Approx(4 * 3.14159265358979 / 3 * 0.729 / 8).epsilon(1e-9));
}

TEST_CASE("With fill the mesh is a shape alone, and the egg stays round") {
  const Scenario s = readWith(sceneInShell("{mesh: egg.obj, fill: 0.4}"));
  const double edge = 2 * shellOf(s).planes[0].offset;
  CHECK(edge * edge * edge * 0.4 == Approx(4 * 3.14159265358979 / 3 * 0.729).epsilon(1e-12));
  CHECK(shellOf(s).mesh.vertices[7].x == Approx(edge / 2).epsilon(1e-12));
  CHECK(s.scene.cells.empty());
  CHECK(readWith(s.resolved).meaning == s.meaning);
  // A ball fills π/6 = 0.5236 of a cube.
  CHECK(complaintsOf(sceneInShell("{mesh: egg.obj, fill: 0.523}")).empty());
  CHECK_THAT(complaintsOf(sceneInShell("{mesh: egg.obj, fill: 0.53}")),
             ContainsSubstring("physics.shell.fill: 0.53 is more than a round egg can fill of this mesh") &&
                 ContainsSubstring("needs at most 0.5235"));
}

TEST_CASE("The mesh counts for the meaning and for how states go on") {
  const Scenario one = readWith(sceneInShell("{mesh: egg.obj}"));
  const Scenario other =
      readWith(sceneInShell("{mesh: egg.obj}"), replaced(cube, "v 1 1 1\n", "v 1 1 1\n# the same\n"));
  CHECK(one.meaning == other.meaning);
  std::string longer = cube;
  for (std::size_t at; (at = longer.find(" 1\n")) != longer.npos && at < longer.find('f');)
    longer.replace(at, 3, " 2\n");
  CHECK(readWith(sceneInShell("{mesh: egg.obj}"), longer).meaning != one.meaning);
  CHECK(read(sceneInShell("{sphere: 1}")).meaning != one.meaning);
}

TEST_CASE("An egg, start cells, planes and Bullet that do not go with the mesh are refused") {
  CHECK_THAT(complaintsOf(sceneInShell("{mesh: egg.obj}", "cell: {radius: 1.1}")),
             ContainsSubstring("physics.cell.radius: 1.1 does not fit into the shell; needs at most the distance of "
                               "the nearest face from the origin, 1 [length]"));
  CHECK_THAT(complaintsOf(sceneInShell("{mesh: egg.obj}") + "cells: [{at: [0.5, 0, 0]}]\n"),
             ContainsSubstring("cells[0]: stands out of the shell"));
  CHECK(complaintsOf(sceneInShell("{mesh: egg.obj}") + "cells: [{at: [0.5, 0.5, 0.5], scale: 0.5}]\n").empty());
  CHECK_THAT(complaintsOf(sceneInShell("{mesh: egg.obj}") + "division: {plane: shell-axis}\n"),
             ContainsSubstring("a shell that is a mesh has no semi-axes"));
  CHECK(complaintsOf(sceneInShell("{mesh: egg.obj}") + "division: {plane: perpendicular}\n").empty());
  CHECK_THAT(complaintsOf(sceneInShell("{mesh: egg.obj, sphere: 1}")), ContainsSubstring("physics.shell"));
  CHECK_THAT(complaintsOf(sceneInShell("{mesh: egg.obj}"), replaced(cube, "v 1 1 1\n", "v 0.5 0.5 0.5\n")),
             ContainsSubstring("egg.obj:") && ContainsSubstring("a shell is convex"));
  CHECK_THAT(complaints(sceneInShell("{mesh: /etc/hostname}")), ContainsSubstring("physics.shell.mesh"));
}
