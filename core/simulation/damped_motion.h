#pragma once
// A world on its way to rest by damped motion (physics/relax_kernel.h), with an inertia of each cell's own that makes
// the step from one evaluation of the forces to the next as long as is stable.
#include <cstdint>
#include <vector>

#include "base/aligned.h"
#include "state/world.h"

namespace morula {

/// The destructor gives cells their masses back. Velocities are kept [length/time].
class DampedMotion {
 public:
  /// `interval` [time]: of the motion between two evaluations.
  DampedMotion(World& world, double interval);
  ~DampedMotion();
  DampedMotion(const DampedMotion&) = delete;
  DampedMotion& operator=(const DampedMotion&) = delete;

  /// Goes on for `evaluations` of the forces. `drag` [1]: share of a motion that one of them takes. Throws
  /// NumericalError as step does.
  void go(double drag, std::uint64_t evaluations);

  /// Goes on until r [rest.h] is at most `residual`, or `most` evaluations have been made. A cell that goes uphill begins
  /// anew from standing, so that all its motions die away, however slow. Returns the number of evaluations.
  std::uint64_t goToRest(double drag, double residual, std::uint64_t most);

  /// Returns the energy [force·length] of the motion that is left.
  double energy() const;

 private:
  using PerSlot = AlignedVector<double>;  // filled up to whole blocks
  void followStiffness(bool anew);
  void evaluate();

  World& world_;
  Bodies& bodies_;
  double interval_;
  std::uint64_t made_ = 0;  // evaluations
  PerSlot masses_, maxMove_, drag_, power_, stiffness_, strain_, factor_;
  std::vector<double> hardening_;  // [block] [1] hardening that inertia counts with
};

}  // namespace morula
