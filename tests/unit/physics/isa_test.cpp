// Every instruction set computes what one cell at a time would: the same bits, in blocks full or not.
#include "catch.h"
#include "lab.h"

using namespace morula;

namespace {

struct Variant {
  const char* name;
  PhysicsParameters parameters;
};

std::vector<Variant> variants() {
  const PhysicsParameters plain = softCell();
  PhysicsParameters undamped = plain, thesis = plain, sphere = plain, ellipsoid = plain;
  PhysicsParameters explicitEuler = plain, symplecticEuler = plain, rungeKutta = plain, kuttaInShell = plain;
  PhysicsParameters xpbd = plain, xpbdInShell = plain, xpbdInEllipsoid = plain;
  undamped.membrane.damping = 0;
  thesis.integrator = Integrator::thesisVerlet;
  thesis.drag = 0.1;
  sphere.shell = ShellParameters{{1, 1, 1}};
  sphere.drag = 0.2;
  ellipsoid.shell = ShellParameters{{1.1, 1, 0.9}};
  explicitEuler.integrator = Integrator::explicitEuler;
  explicitEuler.shell = ShellParameters{{1.1, 1, 0.9}};
  symplecticEuler.integrator = Integrator::symplecticEuler;
  symplecticEuler.shell = ShellParameters{{1, 1, 1}};
  rungeKutta.integrator = kuttaInShell.integrator = Integrator::rungeKutta4;
  kuttaInShell.shell = ShellParameters{{1.1, 1, 0.9}};
  kuttaInShell.drag = 0.2;
  for (PhysicsParameters* p : {&xpbd, &xpbdInShell, &xpbdInEllipsoid}) p->integrator = Integrator::xpbd;
  xpbdInShell.substeps = 3;
  xpbdInShell.membrane.damping = 0;
  xpbdInShell.shell = ShellParameters{{1, 1, 1}};
  xpbdInEllipsoid.shell = ShellParameters{{1.1, 1, 0.9}};
  xpbdInEllipsoid.drag = 0.2;
  PhysicsParameters shapes = plain, dampedShapes = plain;
  shapes.cell.model = dampedShapes.cell.model = CellModel::shapeMatching;
  shapes.shapeMatching = {400, 0, 0};
  dampedShapes.shapeMatching = {400, 0.5, 4};
  dampedShapes.drag = 0.2;
  return {{"plain", plain},
          {"undamped", undamped},
          {"thesis", thesis},
          {"sphere", sphere},
          {"ellipsoid", ellipsoid},
          {"explicit Euler", explicitEuler},
          {"symplectic Euler", symplecticEuler},
          {"Runge-Kutta", rungeKutta},
          {"Runge-Kutta in an ellipsoid", kuttaInShell},
          {"XPBD", xpbd},
          {"XPBD, undamped, in three sub-steps, in a sphere", xpbdInShell},
          {"XPBD in an ellipsoid", xpbdInEllipsoid},
          {"shape matching", shapes},
          {"shape matching, linear, damped", dampedShapes}};
}

std::vector<Body> crowd(const Mesh& mesh, int count) {
  std::vector<Body> cells;
  for (int i = 0; i < count; ++i) {
    cells.push_back(shakenBody(mesh, 0.05, 1, i));
    cells.back().mass = 1 + 0.3 * i;
    cells.back().restScale = 1 + 0.02 * i;
    cells.back().pressureConstant = 6 - 0.1 * i;
  }
  return cells;
}

}  // namespace

TEST_CASE("All instruction sets give one cell's bits at every step") {
  const std::vector<zoo::Animal> meshes{{"icosphere 1", makeIcosphere(1)},
                                        {"cube", zoo::box({-0.6, -0.6, -0.6}, {0.6, 0.6, 0.6})},
                                        {"torus", zoo::scaled(zoo::torus(7, 5), {0.33, 0.33, 0.33}), 1},
                                        {"tetrahedron", zoo::scaled(zoo::tetrahedron(), {0.6, 0.6, 0.6})}};
  REQUIRE(availableIsas().size() >= 2);
  for (const auto& [meshName, mesh, handles] : meshes)
    for (const auto& [variantName, parameters] : variants())
      for (int count : {1, 3, 5, 8, 9}) {
        const auto cells = crowd(mesh, count);
        std::vector<Lab> alone;  // each cell by itself, one at a time
        for (const Body& cell : cells) alone.emplace_back(parameters, mesh, std::vector<Body>{cell}, Isa::scalar);
        for (Lab& lab : alone) lab.start();
        std::vector<Lab> together;
        for (Isa isa : availableIsas()) together.emplace_back(parameters, mesh, cells, isa);
        for (Lab& lab : together) lab.start();
        int firstDifference = -1;
        for (int i = 0; i < 40; ++i) {
          for (Lab& lab : alone) lab.step(0x1p-8);
          for (Lab& lab : together) {
            lab.step(0x1p-8);
            for (int slot = 0; slot < count; ++slot) {
              const Body a = takeBody(alone[slot].bodies, 0), b = takeBody(lab.bodies, slot);
              const bool equal = a.position == b.position && a.velocity == b.velocity &&
                                 alone[slot].bodies.volume[0] == lab.bodies.volume[slot] &&
                                 alone[slot].bodies.pressure[0] == lab.bodies.pressure[slot] &&
                                 alone[slot].force(0, 1) == lab.force(slot, 1);
              if (!equal && firstDifference < 0) firstDifference = i;
            }
          }
        }
        CAPTURE(meshName, variantName, count);
        CHECK(firstDifference == -1);
        // Not the equality of two failures: the cells are alive and have moved.
        CHECK(together[0].bodies.volume[0] > 0);
        CHECK_FALSE(takeBody(together[0].bodies, 0).position == cells[0].position);
      }
}
