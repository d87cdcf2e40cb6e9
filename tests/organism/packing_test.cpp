// The contacts in a packing of 64 cells do not depend on the time step.
#include <set>

#include "base/parallel.h"
#include "catch.h"
#include "observation/measures.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"
#include "simulation/time_step.h"

using namespace morula;

namespace {

using Pairs = std::set<std::pair<std::string, std::string>>;

/// Returns the pairs that touch at the end. The automatic time steps are multiplied by `share` from time `from` on.
Pairs pairsAtEnd(const Scene& scene, double from, double share) {
  World world = makeWorld(scene);
  while (world.clock.time < from) step(world);
  world.bodies->parameters.autoShare = share;
  chooseTimeStep(world);
  while (!finished(world)) step(world);
  Pairs pairs;
  for (const ContactMeasures& touch : measureContacts(world)) pairs.insert({touch.a.text(), touch.b.text()});
  return pairs;
}

}  // namespace

TEST_CASE("shell-64: at an eighth of the time step 97 % of the pairs that touch at the end are the same") {
  // All runs share one state after the last division: before, runs are chaotic, and rounding decides where cells
  // divide.
  constexpr double afterLastDivision = 6.5;
  constexpr int seeds = 3;
  std::vector<std::size_t> touching(seeds);
  std::vector<double> same(seeds);
  parallelFor(seeds, 2, [&](int i) {
    Scene scene = loadScenario(MORULA_SOURCE_DIR "/scenarios/policies/shell-64.yaml").scene;
    scene.seed = i + 1;
    const Pairs whole = pairsAtEnd(scene, afterLastDivision, 1), eighth = pairsAtEnd(scene, afterLastDivision, 0.125);
    const auto both = std::ranges::count_if(whole, [&](const auto& pair) { return eighth.contains(pair); });
    same[i] = 2.0 * static_cast<double>(both) / static_cast<double>(whole.size() + eighth.size());
    touching[i] = whole.size();
  });
  for (int i = 0; i < seeds; ++i) {
    INFO("seed " << i + 1);
    CHECK(touching[i] > 150);
    CHECK(same[i] >= 0.97);
  }
}
