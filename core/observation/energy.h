#pragma once
// The parts of a scene's energy, and its dissipation. A closed scene (contacts by the pair law; no drag, damping,
// viscosity, shell, growth or division) keeps the sum of all parts, except for the second-order error of the time step.
#include "state/world.h"

namespace morula {

/// The parts of the energy [force·length] of all cells.
struct Energy {
  double kinetic = 0;  // ½ Σ m v²
  // ½ k_s (l − l₀)² of every edge, times its weight [Nilsson 2008, eq. 4.2], and bending (physics/bending_kernel.h)
  double membrane = 0;
  double contents = 0;     // k_p (r − 1 − ln r), r = P₀V/k_p: nothing at rest [Nilsson 2008, eq. 4.3]
  double connections = 0;  // k_c |v| [Nilsson 2008, eq. 4.9], or of springs ½ k (d − rest)²
  double contact = 0;      // energy of overlaps: at least 0 (contacts/pair_law_kernel.h); not measured for spheres
  double adhesion = 0;     // minus the work of parting cells: at most 0

  double total() const { return kinetic + membrane + contents + connections + contact + adhesion; }
};

/// Measures the energy of cells without contacts and connections: motion, membranes and contents.
Energy measureEnergy(const Bodies& bodies);

/// Measures the energy of the world as it is, with contacts as the last snapshot saw them. The energy of cell models
/// other than shells with springs, and of spheres in contact, is not included.
Energy measureEnergy(const World& world);

/// Returns the power [force·length/time] that drag, the membranes' damping, and the damping and viscosity of contacts
/// take from the motion now. With its integral over time the energy of a scene without shell, growth and division is
/// constant. It does not include what the shell takes from cells that hit it.
double measureDissipation(const World& world);

}  // namespace morula
