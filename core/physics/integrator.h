#pragma once
// The properties of each integrator: one row of a table (integrator.cpp).
#include <span>

#include "physics/parameters.h"
#include "physics/physics_kernels.h"

namespace morula {

/// The kernels around the evaluations of the forces in one time step.
struct Movement {
  PhysicsKernels::TimedStage drift;                           // before the first evaluation
  std::span<const PhysicsKernels::TimedStage> furtherDrifts;  // before each further evaluation
  const PhysicsKernels::TimedStage* kick;                     // [KickShell] after each evaluation
};

struct IntegratorKind {
  const char* title;          // for people
  int order;                  // order of the error in the time step, for a smooth scene
  int evaluations = 1;        // evaluations of the forces in a time step
  bool needsDrag = false;     // amplifies any motion that is not damped
  bool solvesForces = false;  // its drift solves for inner forces, which then limit no time step
  bool settles = false;       // has no time step: it relaxes to rest (simulation/settle.h)

  /// Returns the largest stable time step [time] for k x + c x' + m x'' = 0.
  double (*oscillatorLimit)(double k, double c, double m);
  double undampedLimit = 2;  // [1] largest stable time step for c = 0, times √(k/m)

  /// Returns the movement for a shell (ShellShape). `damped`: springs are damped; matters to XPBD only.
  Movement (*movement)(const PhysicsKernels&, int shell, bool damped);
};

const IntegratorKind& kindOf(Integrator integrator);

}  // namespace morula
