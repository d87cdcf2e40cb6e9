#include "loop/twin_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>

#include "base/error.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"

namespace morula {
namespace {

constexpr std::array decades{1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8,
                             1e-7,  1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1, 1.0};
constexpr double infinity = std::numeric_limits<double>::infinity();

double nextAbove(double x, Precision precision) {
  return precision == Precision::binary64 ? std::nextafter(x, infinity)
                                          : double(std::nextafter(float(x), std::numeric_limits<float>::infinity()));
}

double distance(const World& a, const World& b) {
  if (a.cells.path != b.cells.path || a.bodies->position.size() != b.bodies->position.size()) return infinity;
  const Reals &p = a.bodies->position, &q = b.bodies->position;  // cells stand in the same places
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) largest = std::max(largest, std::abs(p[i] - q[i]));
  return largest;
}

/// Moves x of the first vertex by one unit in the last place, and returns by how much [length].
double moveByOnePlace(World& twin) {
  MORULA_CHECK(twin.bodies && twin.clock.step == 0, "twins are born at step 0, with bodies");
  Bodies& b = *twin.bodies;
  const double before = b.position[b.at(0, 0)], after = nextAbove(before, b.parameters.precision);
  b.position[b.at(0, 0)] = after;
  return after - before;
}

}  // namespace

Twins::Twins(World world, World twin) : ulp_(moveByOnePlace(twin)), run_(std::move(world)), twin_(std::move(twin)) {}

double Twins::step() {
  std::exception_ptr failure;
  if (twinGoesOn_) {
    try {
      twin_.advance(1);
    } catch (const NumericalError& error) {
      if (error.want != Want::nothing) failure = std::current_exception();
      twinGoesOn_ = false;
    }
  }
  run_.advance(1);
  if (failure) std::rethrow_exception(failure);
  return twinGoesOn_ ? distance(world(), twin_.world()) : infinity;
}

TwinRun runTwins(World world, World twin, const std::function<void(const World&)>& watch) {
  const double radius = world.model.mechanics->physics.cell.radius;
  Twins twins(std::move(world), std::move(twin));
  TwinRun run;
  std::size_t next = 0;
  while (!finished(twins.world())) {
    if (watch) watch(twins.world());
    const double apart = twins.step() / radius;
    for (; next < decades.size() && apart >= decades[next]; ++next)
      run.growth.push_back({decades[next], twins.world().clock.step});
  }
  run.end = hashState(twins.world()).whole;
  return run;
}

}  // namespace morula
