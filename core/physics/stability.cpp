#include "physics/stability.h"

#include <cmath>

#include "physics/cell_model.h"
#include "physics/integrator.h"

namespace morula {

StabilityLimits measureLimits(const Bodies& b, int slot) { return b.model().limits(b, slot); }

double dragLimit(Integrator integrator, double drag) {
  const IntegratorKind& kind = kindOf(integrator);
  return kind.solvesForces ? INFINITY : kind.oscillatorLimit(0, drag, 1);
}

double contactLimit(Integrator integrator, double stiffness, double damping, double vertexMass, double drag,
                    double pairs) {
  const IntegratorKind& kind = kindOf(integrator);
  const double m = vertexMass / pairs;
  if (!kind.needsDrag) return kind.oscillatorLimit(stiffness, damping, m);
  return drag > 0 ? kind.oscillatorLimit(stiffness, damping + drag * m, m) : 0;
}

}  // namespace morula
