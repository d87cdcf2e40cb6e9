// Cells whose vertices are drawn to the shape at rest (shape_kernel.h); they have no membrane and no pressure.
#include <algorithm>
#include <cmath>

#include "physics/cell_model.h"
#include "physics/integrator.h"
#include "physics/stability.h"
#include "physics/stages.h"

namespace morula {
namespace {

void chooseShapeForces(PhysicsStages& s, const PhysicsKernels& k, const PhysicsParameters& p, bool surfaces) {
  const bool resisted = p.shapeMatching.damping > 0 || p.drag > 0;
  if (surfaces) s.accumulateRings = k.accumulateAreaVectors;
  s.finishForces = k.findShapeForces[resisted][!surfaces];
}

/// The stiffest mode oscillates fastest. With much damping the softest mode, in the direction of β, relaxes fastest.
StabilityLimits shapeLimits(const Bodies& b, int) {
  const IntegratorKind& integrator = kindOf(b.parameters.integrator);
  const ShapeMatchingParameters& shape = b.parameters.shapeMatching;
  const double k = shape.stiffness, soft = (1 - shape.linear) * k, c = shape.damping + b.parameters.drag;
  if (integrator.needsDrag && !(c > 0)) return {0, INFINITY};
  return {std::min(integrator.oscillatorLimit(k, c, 1), integrator.oscillatorLimit(soft, c, 1)), INFINITY};
}

}  // namespace

const CellModelKind shapeMatchingCells{
    .hasRestShape = true, .limitedBy = "shape-matching", .chooseForces = chooseShapeForces, .limits = shapeLimits};

}  // namespace morula
