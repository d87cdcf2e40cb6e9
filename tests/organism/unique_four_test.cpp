// The thesis' four cells touch the same neighbours with every mesh and time step.
#include "catch.h"
#include "organism/four_cells.h"

using namespace four_cells;

TEST_CASE("unique-four: the same four contacts whatever the mesh, the time step, the precision and viscosity") {
  const std::vector<std::vector<std::string>> settings{{},
                                                       {"physics.mesh.icosphere=3"},
                                                       {"physics.mesh.icosphere=4"},
                                                       {"physics.time_step={auto: 0.125}"},
                                                       {"physics.precision=single"},
                                                       {"physics.contact.viscosity=0.3"}};
  std::vector<Arrangement> found(settings.size());
  parallelFor(static_cast<int>(settings.size()), 2,
              [&](int i) { found[i] = runSeeds("thesis/unique-four.yaml", 1, settings[i])[0]; });
  for (std::size_t i = 0; i < settings.size(); ++i) {
    INFO((settings[i].empty() ? "as shipped" : settings[i][0]));
    CHECK(found[i].name == "square");
    // The arrangement's name ignores small contacts, the map does not.
    REQUIRE(found[i].contact.size() == 4);
    for (const char* pair : {"AA-AB", "AA-BA", "AB-BB", "BA-BB"}) CHECK(found[i].contact.contains(pair));
  }
}
