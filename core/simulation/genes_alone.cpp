#include "simulation/genes_alone.h"

#include "simulation/cycle_lengths.h"

namespace morula {

Scene genesAlone(Scene scene) {
  scene.mechanics.reset();
  if (std::erase_if(scene.stop.when, needsBodies) > 0 && !plannedEnd(scene))
    scene.stop.time = maxCyclesForCells * longestCycle(scene.cycle);
  return scene;
}

}  // namespace morula
