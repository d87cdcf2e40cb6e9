// Near rest, the shape matching that replaces a shell has the shell's forces.
#include "catch.h"
#include "reader.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

/// Returns ω² of the motion x → (1 + ε e)x: the restoring force along the motion over ε, summed over vertices.
double squaredFrequency(const PhysicsParameters& p, const Mesh& mesh, const Vector& e) {
  constexpr double small = 1e-6;
  Body body{mesh.vertices, std::vector<Vector>(mesh.vertices.size()), 1, 1, p.pressure.constant};
  double inertia = 0;
  for (Point& x : body.position) {
    const Vector way{e.x * x.x, e.y * x.y, e.z * x.z};
    inertia += dot(way, way);
    x += small * way;
  }
  Lab lab(p, mesh, {body});
  lab.evaluate();
  double pull = 0;
  for (int v = 0; v < lab.bodies.vertexCount(); ++v) {
    const Point& x = mesh.vertices[static_cast<std::size_t>(v)];
    pull -= dot(lab.force(0, v), {e.x * x.x, e.y * x.y, e.z * x.z});
  }
  return pull / lab.bodies.vertexMass[0] / inertia / small;
}

/// Returns a shell whose gas just balances the outside pressure.
PhysicsParameters restingShell(const Mesh& mesh) {
  PhysicsParameters p;
  p.pressure.constant = p.pressure.outside * measureVolume(mesh.vertices, mesh.faces);
  return p;
}

const AccuracyRow* best(const AccuracyReport& report, const std::string& series) {
  const AccuracyRow* found = nullptr;
  for (const AccuracyRow& r : report.rows)
    if (r.series == series && r.error && (!found || *r.error < *found->error)) found = &r;
  return found;
}

}  // namespace

TEST_CASE("Shape matching in a shell's place breathes and swings as fast") {
  for (const auto& [level, springs] :
       {std::pair{1, Springs::equal}, {2, Springs::equal}, {1, Springs::dual}, {2, Springs::dual}}) {
    const Mesh mesh = makeIcosphere(level);
    PhysicsParameters shell = restingShell(mesh);
    shell.membrane.springs = springs;
    PhysicsParameters matched;
    matched.cell.model = CellModel::shapeMatching;
    matched.shapeMatching = matchShell(shell, mesh);
    // A slope over a step of 1e-6 has an error of about as much.
    CHECK(squaredFrequency(matched, mesh, {1, 1, 1}) == Approx(squaredFrequency(shell, mesh, {1, 1, 1})).epsilon(1e-5));
    // An icosphere is equally stiff in all directions: its symmetry allows no other form of second degree.
    for (const Vector& e : {Vector{1, -0.5, -0.5}, Vector{-0.5, -0.5, 1}, Vector{1, -1, 0}})
      CHECK(squaredFrequency(matched, mesh, e) == Approx(squaredFrequency(shell, mesh, e)).epsilon(1e-5));
  }
}

TEST_CASE("Cheaper models leave out, and never add") {
  CHECK(cheaperThan(CellModel::shell) == std::vector{CellModel::shapeMatching, CellModel::sphere});
  CHECK(cheaperThan(CellModel::shapeMatching) == std::vector{CellModel::sphere});
  CHECK(cheaperThan(CellModel::sphere).empty());
}

TEST_CASE("Two cells in a shell as shells, matched shapes and spheres: each has its error and its price") {
  const std::string pair =
      "morula: 1\nname: pair\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 0.5}\n"
      "physics:\n  mesh: {icosphere: 1}\n  membrane: {stiffness: 12}\n  drag: 10\n  cell: {radius: 1}\n"
      "  contact: {radius: 1.1}\ncells:\n  - {at: [0.97, 0, 0]}\n  - {at: [-0.97, 0, 0]}\n";
  const AccuracyReport report = measureAccuracy(reader(pair), fewSettings());
  INFO(textOf(describe(report)));
  const AccuracyRow *shell = best(report, "velocity-verlet"),
                    *matched = best(report, "velocity-verlet, shape-matching"),
                    *sphere = best(report, "velocity-verlet, sphere");
  REQUIRE(shell);
  REQUIRE(matched);
  REQUIRE(sphere);
  CHECK(*shell->error < 0.1 * *matched->error);
  CHECK(*matched->error < 0.2);
  CHECK(*sphere->error < 0.2);
  CHECK(sphere->vertexSteps == 2 * sphere->steps);
  CHECK(matched->vertexSteps == 2 * 42 * matched->steps);
}

TEST_CASE("A lone sphere in no medium bears any time step: the longest that is tried is that between two looks") {
  const std::string lone =
      "morula: 1\nname: lone\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {time: 1}\nphysics:\n"
      "  mesh: {icosphere: 1}\n  drag: 0\n";
  const AccuracyReport report = measureAccuracy(reader(lone), fewSettings());
  INFO(textOf(describe(report)));
  const AccuracyRow* sphere = best(report, "velocity-verlet, sphere");
  REQUIRE(sphere);
  for (const AccuracyRow& row : report.rows) CHECK(row.setting.timeStep <= report.times.front());
}
