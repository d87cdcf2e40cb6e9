// Cells of one vertex with a radius (sphere_kernel.h); nothing inside them oscillates.
#include <cmath>

#include "physics/cell_model.h"
#include "physics/stability.h"
#include "physics/stages.h"

namespace morula {
namespace {

void chooseSphereForces(PhysicsStages& s, const PhysicsKernels& k, const PhysicsParameters& p, bool) {
  s.finishForces = p.drag > 0 ? k.measureDraggedSpheres : k.measureSpheres;
}

StabilityLimits sphereLimits(const Bodies&, int) { return {INFINITY, INFINITY}; }

}  // namespace

const CellModelKind sphereCells{
    .hasMesh = false, .limitedBy = "", .chooseForces = chooseSphereForces, .limits = sphereLimits};

}  // namespace morula
