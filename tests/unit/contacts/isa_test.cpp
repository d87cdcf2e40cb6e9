// Every instruction set finds the same contact forces, bit for bit, in blocks full or not.
#include "catch.h"
#include "crowd.h"

using namespace morula;

TEST_CASE("All instruction sets move touching cells alike, at every step") {
  REQUIRE(availableIsas().size() >= 2);
  PhysicsParameters p = softCell();
  p.membrane = {40, 0.05, 1.26};
  p.pressure = {4, 0};
  std::vector<ContactParameters> laws{{}, {ContactLaw::pair, 40, 0.05, 0.3}, {ContactLaw::thesis}};
  for (double viscosity : {0.0, 0.3}) {  // viscosity has kernels of its own
    laws.push_back({ContactLaw::pair, 40, 0.05, viscosity, 0.01, 1.5});
    laws.back().adhesion = AdhesionParameters{3, {}};
  }
  const std::vector<Mesh> meshes{makeIcosphere(1), zoo::scaled(zoo::torus(7, 5), {0.33, 0.33, 0.33}),
                                 zoo::box({-0.6, -0.6, -0.6}, {0.6, 0.6, 0.6})};
  for (const Mesh& mesh : meshes)
    for (const ContactParameters& law : laws)
      for (int count : {1, 2, 3, 5, 9}) {
        auto cells = heap(mesh, count, 1.7, 0.5);
        for (Body& b : cells) b.pressureConstant = 4 * b.mass;
        std::vector<Crowd> crowds;
        for (Isa isa : availableIsas()) crowds.emplace_back(p, law, mesh, cells, isa);
        int firstDifference = -1;
        for (int i = 0; i < 60; ++i)
          for (Crowd& crowd : crowds) {
            crowd.step(0x1p-9);
            for (int slot = 0; slot < count; ++slot) {
              const Body a = takeBody(crowds[0].lab.bodies, slot), b = takeBody(crowd.lab.bodies, slot);
              if (!(a.position == b.position && a.velocity == b.velocity) && firstDifference < 0) firstDifference = i;
            }
            if (!(crowd.contacts.rebuilds == crowds[0].contacts.rebuilds) && firstDifference < 0) firstDifference = i;
          }
        CAPTURE(mesh.vertices.size(), static_cast<int>(law.law), law.viscosity, count);
        CHECK(firstDifference == -1);
      }
}
