#pragma once
// A run of a scenario in which Bullet moves the bodies. Its World can be measured as any other.
#include "engines/bullet_world.h"
#include "loop/simulate.h"

namespace morula {

class BulletRun {
 public:
  /// Begins the scenario. Bullet takes the scenario's time step as a float, whatever its stability; without one, our
  /// time step. `margin`: in radii of the egg; `integrator`: for B1, as in BulletScene. Throws InputError if the
  /// scenario cannot begin.
  BulletRun(const Scenario& scenario, Baseline baseline, double margin, Integrator integrator);

  void step();
  const World& world() const { return world_; }

 private:
  void take(const std::vector<Body>& cells);

  World world_;  // without contacts: Bullet computes them
  std::unique_ptr<BulletWorld> bullet_;
};

/// Makes the world in which the scenario begins, with its time step.
World makeBulletStart(Scenario scenario);

/// Moves the cells of a world of makeBulletStart into these shapes, by path; volumes and pressures follow. Velocities
/// stay.
void placeCells(World& world, const std::vector<std::vector<Point>>& shapes);

}  // namespace morula
