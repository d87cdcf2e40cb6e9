#include "simulation/genes_alone.h"

#include "simulation/cycle_lengths.h"

namespace morula {

bool needsBodies(const Experiment& experiment) {
  return experiment.deed == Deed::set || experiment.deed == Deed::connect || experiment.deed == Deed::release;
}

Scene genesAlone(Scene scene) {
  scene.mechanics.reset();
  std::erase_if(scene.experiments, [](const Experiment& e) { return needsBodies(e); });
  const auto waited = std::erase_if(scene.stop.when, [](const StopWhen& when) { return needsBodies(when); });
  if (waited > 0 && !plannedEnd(scene)) scene.stop.time = maxCyclesForCells * longestCycle(scene.cycle);
  return scene;
}

}  // namespace morula
