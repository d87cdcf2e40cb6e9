#pragma once
// A scenario's run in which Bullet moves the bodies: all that measures a World measures it.
#include "engines/bullet_world.h"
#include "loop/simulate.h"

namespace morula {

class BulletRun {
 public:
  /// The scenario's start. Bullet takes the scenario's time step whatever we think of its stability, as a
  /// float, and without one ours. `margin` in radii of the egg; `integrator`: of B1, as in BulletScene. Throws
  /// InputError if there is no start.
  BulletRun(const Scenario& scenario, Baseline baseline, double margin, Integrator integrator);

  void step();
  const World& world() const { return world_; }

 private:
  void take(const std::vector<Body>& cells);

  World world_;  // without contacts: ours have no say in it
  std::unique_ptr<BulletWorld> bullet_;
};

/// Makes the world in which the scenario begins, with its time step.
World makeBulletStart(Scenario scenario);

/// Puts the cells of such a world, by path, into these shapes; volumes and pressures follow. Velocities stay.
void placeCells(World& world, const std::vector<std::vector<Point>>& shapes);

}  // namespace morula
