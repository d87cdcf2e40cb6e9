#include "explain/parting.h"

#include <cmath>

#include "base/error.h"
#include "base/number_text.h"
#include "loop/simulate.h"
#include "simulation/world.h"
#include "system/signals.h"

namespace morula {
namespace {

/// The vertex that is the farthest from where it was before.
struct Farthest {
  double distance = 0;  // [length]
  std::size_t cell = 0;
  int vertex = 0;
};

Farthest farthest(const World& before, const World& now) {
  Farthest most;
  for (std::size_t i = 0; i < now.cells.path.size(); ++i) {
    const int a = before.bodies->slots[i], b = now.bodies->slots[i];
    for (int v = 0; v < std::min(before.bodies->vertexCount(a), now.bodies->vertexCount(b)); ++v) {
      const Vector d = now.bodies->vertex(b, v) - before.bodies->vertex(a, v);
      if (const double r = std::sqrt(dot(d, d)); r > most.distance) most = {r, i, v};
    }
  }
  return most;
}

bool stepBoth(World& a, World& b) {
  if (finished(a) || finished(b)) return false;
  stopAtSignal();
  try {
    step(a), step(b);
  } catch (const NumericalError&) { return false; }
  return a.clock.time == b.clock.time && a.cells.path == b.cells.path;
}

}  // namespace

std::string partingInWords(const Scenario& before, const Scenario& now, const Execution& how) {
  World a = makeScenarioWorld(before, how), b = makeScenarioWorld(now, how);
  if (!a.bodies || !b.bodies) return {};
  const double radius = before.scene.mechanics->physics.cell.radius;
  std::string first, apart;
  double next = 1e-3;  // [radii]
  do {
    const Farthest most = farthest(a, b);
    if (most.distance == 0) continue;
    const std::string cell = cellName(b.cells.path[most.cell].text()), step = std::to_string(b.clock.step);
    if (first.empty())
      first = "  moves     first at step " + step + ", time " + numberText(b.clock.time) + ": " + cell + ", vertex " +
              std::to_string(most.vertex) + ", by " + numberText(most.distance / radius, 3) + " radii of the egg\n";
    for (; next < 1 && most.distance >= next * radius; next *= 10)
      apart += (apart.empty() ? "  apart     by " : ", ") + numberText(next) + " radii from step " + step + " on (" +
               cell + ")";
  } while (stepBoth(a, b));
  return first + apart + (apart.empty() ? "" : "\n");
}

}  // namespace morula
