#include "state/scene.h"

#include <algorithm>

#include "biology/substances.h"

namespace morula {

std::optional<double> plannedEnd(const Scene& scene) {
  std::optional<double> end = scene.stop.time;
  if (scene.stop.cycles) {
    const double cycles = static_cast<double>(*scene.stop.cycles) * scene.cycle.length;
    end = end ? std::min(*end, cycles) : cycles;
  }
  return end;
}

bool usesSeed(const Scene& scene) {
  const VariationParameters& v = scene.variation;
  if (v.cycle > 0 || (scene.mechanics && v.start > 0)) return true;
  if (std::ranges::any_of(scene.experiments, [](const Experiment& e) { return e.share < 1; })) return true;
  const auto divides = [&](const Gene& gene) { return scene.dna.substances[gene.product] == substance::divide; };
  if (scene.mechanics && (scene.mechanics->physics.motility || v.adhesion > 0)) return true;
  if (!scene.mechanics || std::ranges::none_of(scene.dna.genes, divides)) return false;
  const DivisionParameters& division = scene.mechanics->division;
  return v.share > 0 || v.tilt > 0 || kindOf(division.otherwise.plane).usesSeed ||
         std::ranges::any_of(division.rules, [](const DivisionRule& rule) {
           return rule.tilt.value_or(0) > 0 || (rule.plane && kindOf(rule.plane->plane).usesSeed);
         });
}

}  // namespace morula
