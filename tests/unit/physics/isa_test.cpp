// Every instruction set computes the bits of one cell at a time, in blocks full or not.
#include "catch.h"
#include "lab.h"

using namespace morula;

namespace {

struct Variant {
  const char* name;
  PhysicsParameters parameters;
};

std::vector<Variant> variants() {
  const ShellParameters sphere{{1, 1, 1}}, ellipsoid{{1.1, 1, 0.9}};
  std::vector<Variant> list;
  const auto add = [&](const char* name, auto change) {
    list.push_back({name, softCell()});
    change(list.back().parameters);
  };
  add("plain", [](auto&) {});
  add("undamped", [](auto& p) { p.membrane.damping = 0; });
  add("thesis", [](auto& p) { p.integrator = Integrator::thesisVerlet, p.drag = 0.1; });
  add("sphere", [&](auto& p) { p.shell = sphere, p.drag = 0.2; });
  add("ellipsoid", [&](auto& p) { p.shell = ellipsoid; });
  add("explicit Euler", [&](auto& p) { p.integrator = Integrator::explicitEuler, p.shell = ellipsoid; });
  add("symplectic Euler", [&](auto& p) { p.integrator = Integrator::symplecticEuler, p.shell = sphere; });
  add("Runge-Kutta", [](auto& p) { p.integrator = Integrator::rungeKutta4; });
  add("Runge-Kutta in an ellipsoid",
      [&](auto& p) { p.integrator = Integrator::rungeKutta4, p.shell = ellipsoid, p.drag = 0.2; });
  add("XPBD", [](auto& p) { p.integrator = Integrator::xpbd; });
  add("XPBD, undamped, in three sub-steps, in a sphere",
      [&](auto& p) { p.integrator = Integrator::xpbd, p.substeps = 3, p.membrane.damping = 0, p.shell = sphere; });
  add("XPBD in an ellipsoid", [&](auto& p) { p.integrator = Integrator::xpbd, p.shell = ellipsoid, p.drag = 0.2; });
  add("shape matching", [](auto& p) { p.cell.model = CellModel::shapeMatching, p.shapeMatching = {400, 0, 0}; });
  add("shape matching, linear, damped", [](auto& p) {
    p.cell.model = CellModel::shapeMatching, p.shapeMatching = {400, 0.5, 4}, p.drag = 0.2;
  });
  return list;
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
        std::vector<Lab> alone;  // one lab for each cell
        for (const Body& cell : cells) alone.emplace_back(parameters, mesh, std::vector<Body>{cell}, Isa::scalar);
        std::vector<Lab> together;
        for (Isa isa : availableIsas()) together.emplace_back(parameters, mesh, cells, isa);
        for (int slot = 0; slot < count; ++slot)  // sag depends on all cells of a shell (physics/sag.h)
          alone[slot].bodies.sag[0] = together[0].bodies.sag[slot];
        for (Lab& lab : alone) lab.start();
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
        // Two failures would be equal, too: the cells must be alive and have moved.
        CHECK(together[0].bodies.volume[0] > 0);
        CHECK_FALSE(takeBody(together[0].bodies, 0).position == cells[0].position);
      }
}
