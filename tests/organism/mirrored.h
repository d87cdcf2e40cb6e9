#pragma once
// Mirrors scenes in which only division axes and chirality tell left from right.
#include "observation/measures.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"
#include "worst.h"

namespace mirrored {

using namespace morula;

enum class Axis { y, z };

inline Vector mirror(Vector v, Axis axis) {
  (axis == Axis::y ? v.y : v.z) *= -1;
  return v;
}

/// Returns the scene without effects of the seed, which have no mirror image.
inline Scene withoutSeed(Scene scene) {
  scene.variation = {};
  for (DivisionRule& rule : scene.mechanics->division.rules) rule.tilt.reset();
  return scene;
}

inline Scene mirror(Scene scene, Axis axis) {
  scene.mechanics->division.otherwise.axis = mirror(scene.mechanics->division.otherwise.axis, axis);
  for (DivisionRule& rule : scene.mechanics->division.rules)
    if (rule.plane) rule.plane->axis = mirror(rule.plane->axis, axis);
  return scene;
}

inline Point centreOf(const CellMeasures& m) { return {m.at("x"), m.at("y"), m.at("z")}; }

/// Returns the max distance [length] of cells from the mirror images of the other world's cells; infinite if other
/// cells live or touch.
inline double difference(const World& world, const World& other, Axis axis) {
  const auto a = measureCells(world), b = measureCells(other);
  const auto touchA = measureContacts(world), touchB = measureContacts(other);
  if (a.size() != b.size() || touchA.size() != touchB.size()) return INFINITY;
  for (std::size_t i = 0; i < touchA.size(); ++i)
    if (touchA[i].a != touchB[i].a || touchA[i].b != touchB[i].b) return INFINITY;
  Worst worst;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].path != b[i].path) return INFINITY;
    worst.see(norm(centreOf(a[i]) - mirror(centreOf(b[i]), axis)));
  }
  return worst;
}

}  // namespace mirrored
