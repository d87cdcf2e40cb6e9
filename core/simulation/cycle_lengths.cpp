
#include "simulation/cycle_lengths.h"

#include <algorithm>

#include "base/error.h"
#include "base/number_text.h"
#include "base/random.h"

namespace morula {
namespace {

constexpr double maxCycles = 1e12;  // max cycles in succession; more than a week of a cell without a body

}  // namespace

ShortestCycle shortestCycle(const CycleParameters& cycle) {
  ShortestCycle shortest{cycle.length, "cycle.length"};
  for (const auto& [substance, length] : cycle.perSubstance)
    if (length < shortest.length) shortest = {length, "cycle.per-substance." + substance};
  for (const auto& [substance, length] : cycle.atBirth)
    if (length < shortest.length) shortest = {length, "cycle.at-birth." + substance};
  return shortest;
}

ShortestCycle shortestCycle(const Scene& scene) {
  ShortestCycle shortest = shortestCycle(scene.cycle);
  shortest.length *= 1 - largestDeviate * scene.variation.cycle;
  return shortest;
}

double longestCycle(const CycleParameters& cycle) {
  double longest = cycle.length;
  for (const auto* lengths : {&cycle.perSubstance, &cycle.atBirth})
    for (const auto& [substance, length] : *lengths) longest = std::max(longest, length);
  return longest;
}

void refuseEndlessPace(const Scene& scene) {
  const ShortestCycle shortest = shortestCycle(scene);
  const double until = std::max(longestCycle(scene.cycle), plannedEnd(scene).value_or(0));
  if (until <= maxCycles * shortest.length) return;
  throw InputError::at(shortest.key, " " + exactText(shortest.length) + " is too short for a time of " +
                                         exactText(until) + ", which is the run's end or another cycle: more than " +
                                         numberText(maxCycles) + " cell cycles; give a longer one, at least " +
                                         numberText(until / maxCycles) + ", or stop earlier");
}

}  // namespace morula
