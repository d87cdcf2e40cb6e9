// A convex mesh as a shell holds every vertex and bears the forces that press on it.
#include "base/isa.h"
#include "catch.h"
#include "round_shell.h"

using namespace morula;

namespace {

/// Returns a shell with the given planes; tests of meshes cover reading planes from a file.
ShellParameters shellOf(std::vector<ShellPlane> planes) {
  ShellParameters shell;
  shell.mesh = std::make_shared<ConvexShell>(ConvexShell{{}, std::move(planes)});
  return shell;
}

ShellParameters cube() {
  return shellOf({{{1, 0, 0}, 1}, {{-1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}, {{0, 0, 1}, 1}, {{0, 0, -1}, 1}});
}

/// Returns a tetrahedron, whose edges are acute: 70.5 degrees.
ShellParameters tetrahedron() {
  const double n = 1 / std::sqrt(3.0);
  return shellOf({{{n, n, -n}, 0.7}, {{-n, -n, -n}, 0.7}, {{-n, n, n}, 0.7}, {{n, -n, n}, 0.7}});
}

/// Returns the planes that touch the unit sphere in the directions of an icosphere's vertices.
ShellParameters almostSphere() {
  std::vector<ShellPlane> planes;
  for (const Point& x : makeIcosphere(3).vertices) planes.push_back({x / norm(x), 1});
  return shellOf(planes);
}

double reachOf(const Point& x, const ShellParameters& shell) {
  double reach = 0;
  for (const ShellPlane& p : shell.mesh->planes)
    reach = std::max(reach, (p.normal.x * x.x + p.normal.y * x.y + p.normal.z * x.z) / p.offset);
  return reach;
}

}  // namespace

TEST_CASE("Every vertex is within every plane after every step, with every integrator") {
  const Mesh mesh = zoo::scaled(makeIcosphere(2), {0.95, 0.95, 0.95});  // pressed into the tetrahedron
  for (const ShellParameters& shell : {cube(), tetrahedron()})
    for (const auto& [integrator, word, meaning] : choices<Integrator>) {
      PhysicsParameters p = inShell(shell);
      p.integrator = integrator;
      p.drag = 1;
      p.pressure.constant = 100;
      Body body = shakenBody(mesh, 0, 5);
      body.pressureConstant = p.pressure.constant;
      Lab lab(p, mesh, {body});
      lab.start();
      Worst farthest;
      int touching = 0;
      for (int i = 0; i < 300; ++i) {
        lab.step(0x1p-11);
        for (const Point& x : lab.positions()) {
          farthest.see(reachOf(x, shell));
          touching += reachOf(x, shell) > 1 - 1e-12;
        }
      }
      CAPTURE(word);
      CHECK(farthest <= 1 + 1e-12);
      CHECK(touching > 100);
    }
}

TEST_CASE("In a cube a vertex outside comes to its nearest point, and keeps what leads along it") {
  const Mesh mesh = makeIcosphere(0);
  PhysicsParameters p = inShell(cube());
  p.membrane = {0, 0, 1};
  Body body = shakenBody(mesh, 0, 0);
  const auto set = [&](int v, const Point& x, const Vector& u) { body.position[v] = x, body.velocity[v] = u; };
  set(0, {1.5, 0.25, 0.5}, {1, 2, 3});    // out of a face
  set(1, {1.5, -1.25, 0.5}, {1, -2, 3});  // out of an edge
  set(2, {1.5, 1.25, 2}, {1, 2, 3});      // out of a corner
  set(3, {1.5, 0.25, 0.5}, {-1, 2, 3});   // on its way in
  set(4, {0.5, 0.25, 0.5}, {1, 2, 3});    // inside
  Lab lab(p, mesh, {body});
  lab.evaluate();
  CHECK(lab.bodies.vertex(0, 0) == Point{1, 0.25, 0.5});
  CHECK(lab.velocity(0, 0) == Vector{0, 2, 3});
  CHECK(lab.bodies.vertex(0, 1) == Point{1, -1, 0.5});
  CHECK(lab.velocity(0, 1) == Vector{0, 0, 3});
  CHECK(lab.bodies.vertex(0, 2) == Point{1, 1, 1});
  CHECK(lab.velocity(0, 2) == Vector{0, 0, 0});
  CHECK(lab.bodies.vertex(0, 3) == Point{1, 0.25, 0.5});
  CHECK(lab.velocity(0, 3) == Vector{-1, 2, 3});
  CHECK(lab.bodies.vertex(0, 4) == Point{0.5, 0.25, 0.5});
  CHECK(lab.velocity(0, 4) == Vector{1, 2, 3});
  // The shell bears the forces that press on it.
  for (int v = 0; v < 5; ++v) lab.bodies.write(lab.bodies.acceleration, 0, v, Vector{1, 2, 3});
  lab.endEvaluation();
  CHECK(lab.force(0, 0).x == 0);
  CHECK(lab.force(0, 0).y > 0);
  CHECK(lab.force(0, 1).x == 0);
  CHECK(lab.force(0, 1).y > 0);
  CHECK(lab.force(0, 2) == Vector{0, 0, 0});
  CHECK(lab.force(0, 4).x > 0);
}

TEST_CASE("Many planes around a sphere hold a cell as the sphere does: to 0.005 of its radius, and 1 % of its volume") {
  const Mesh mesh = zoo::scaled(makeIcosphere(2), {0.9, 0.9, 0.9});
  ShellParameters round;
  round.holds = Held::vertices;  // as planes do
  std::vector<Lab> labs;
  for (const ShellParameters& shell : {round, almostSphere()}) {
    PhysicsParameters p = inShell(shell);
    p.pressure.constant = 400;
    p.drag = 4;
    p.membrane.damping = 0.5;
    labs.push_back(stepped({p, mesh}, 2048, 0x1p-9));
  }
  // Half the distance of neighbouring directions, 0.09, from its point of contact a plane stands out by 0.09²/2.
  for (int v = 0; v < labs[0].bodies.vertexCount(); ++v) {
    CHECK(norm(labs[0].bodies.vertex(0, v)) == Approx(1).epsilon(1e-12));
    CHECK(norm(labs[1].bodies.vertex(0, v)) > 1 - 1e-12);
    CHECK(norm(labs[1].bodies.vertex(0, v)) < 1.005);
  }
  CHECK(labs[1].bodies.volume[0] == Approx(labs[0].bodies.volume[0]).epsilon(0.01));
}

TEST_CASE("All instruction sets give the same bits in planes, with meshes and with balls") {
  for (const bool balls : {false, true})
    for (const ShellParameters& shell : {cube(), tetrahedron()}) {
      PhysicsParameters p = inShell(shell);
      if (balls) p.cell = {.radius = 0.3, .mass = 1, .model = CellModel::sphere};
      p.pressure.constant = 40;
      const Mesh mesh = zoo::scaled(makeIcosphere(1), {0.95, 0.95, 0.95});
      std::vector<Body> cells;
      for (int i = 0; i < 9; ++i) {
        Body cell =
            balls ? Body{.position = {{0.1 * i, 0, 0}}, .velocity = {noiseVector(i, 4)}} : shakenBody(mesh, 0.05, 3, i);
        cell.mass = 1 + 0.1 * i;
        cell.pressureConstant = balls ? 0 : 40;
        cells.push_back(cell);
      }
      std::vector<Lab> labs;
      for (const Isa isa : availableIsas()) labs.push_back(stepped({p, mesh, cells, isa}, 100, 0x1p-8));
      int touching = 0;
      for (int slot = 0; slot < 9; ++slot)
        for (const Point& x : labs[0].positions(slot)) touching += reachOf(x, shell) > (balls ? 0.5 : 1 - 1e-12);
      CHECK(touching > 0);
      for (const Lab& lab : labs)
        for (int slot = 0; slot < 9; ++slot) {
          const Body one = takeBody(labs[0].bodies, slot), other = takeBody(lab.bodies, slot);
          CHECK(one.position == other.position);
          CHECK(one.velocity == other.velocity);
        }
    }
}

TEST_CASE("A ball touches a plane with its surface") {
  PhysicsParameters p = inShell(cube());
  p.cell = {.radius = 0.25, .mass = 1, .model = CellModel::sphere};
  Body ball{.position = {{0.9, 0.1, -2}}, .velocity = {{1, 2, -3}}};
  ball.mass = 1;
  const Lab lab = evaluated({p, makeIcosphere(0), {ball}});
  CHECK(lab.bodies.vertex(0, 0) == Point{0.75, 0.1, -0.75});
  CHECK(lab.velocity(0, 0) == Vector{0, 2, 0});
}

TEST_CASE("A cell turned with its shell moves as before, turned") {
  const auto turned = [](const Vector& a) { return Vector{-a.y, a.x, a.z}; };
  const ShellParameters shell = tetrahedron();
  std::vector<ShellPlane> planes;
  for (const ShellPlane& plane : shell.mesh->planes) planes.push_back({turned(plane.normal), plane.offset});
  const Mesh mesh = zoo::scaled(makeIcosphere(1), {0.65, 0.65, 0.65});
  Mesh turnedMesh = mesh;
  for (Point& x : turnedMesh.vertices) x = turned(x);
  Body body = shakenBody(mesh, 0, 5);
  Lab as(inShell(shell), mesh, {body});
  for (Point& x : body.position) x = turned(x);
  for (Vector& u : body.velocity) u = turned(u);
  Lab after(inShell(shellOf(planes)), turnedMesh, {body});
  Worst difference;
  int touching = 0;
  for (int i = 0; i < 100; ++i) {
    as.step(0x1p-9);
    after.step(0x1p-9);
    for (int v = 0; v < as.bodies.vertexCount(); ++v) {
      const Point x = as.bodies.vertex(0, v);
      difference.see(norm(turned(x) - after.bodies.vertex(0, v)));
      touching += reachOf(x, shell) > 1 - 1e-12;
    }
  }
  CHECK(difference < 1e-10);
  CHECK(touching > 20);
}
