// Tests a conjecture of [Nilsson 2008, §6.2.5]: "This mechanism can probably make it possible to code the same organism
// with less complex code."
#include <map>

#include "catch.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"

using namespace morula;

namespace {

struct Organism {
  std::size_t genes;
  std::map<CellPath, std::string> fates;  // "red", "blue" or others
};

Organism grow(const std::string& name) {
  const Scenario scenario = loadScenario(MORULA_SOURCE_DIR "/scenarios/thesis/" + name + ".yaml");
  World world = makeWorld(scenario.scene);
  while (!finished(world)) step(world);
  Organism organism{scenario.scene.dna.genes.size(), {}};
  for (std::size_t i = 0; i < world.cells.path.size(); ++i) {
    const std::string state = ' ' + world.biology->describe(world.cells.state[i]) + ' ';
    const bool red = state.find(" red ") != state.npos, blue = state.find(" blue ") != state.npos;
    organism.fates[world.cells.path[i]] = red == blue ? state : red ? "red" : "blue";
  }
  return organism;
}

}  // namespace

TEST_CASE("cells that do as most of their neighbours: the same organism with fewer genes") {
  const Organism listening = grow("majority"), written = grow("majority-written-out");
  CHECK(listening.fates.size() == 32);
  CHECK(listening.fates == written.fates);
  CHECK(listening.genes == 24);
  CHECK(written.genes == 39);
}
