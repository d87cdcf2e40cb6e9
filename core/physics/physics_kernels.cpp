// Compiled once per instruction set (core/CMakeLists.txt); see physics_dispatch.cpp for the choice.
#include "physics/physics_kernels.h"

#include "physics/euler_kernel.h"
#include "physics/isolated_kernel.h"
#include "physics/pressure_kernel.h"
#include "physics/ring_kernel.h"
#include "physics/runge_kutta_kernel.h"
#include "physics/shape_kernel.h"
#include "physics/shell_planes_kernel.h"
#include "physics/shell_surface_kernel.h"
#include "physics/sphere_kernel.h"
#include "physics/spring_kernel.h"
#include "physics/verlet_kernel.h"
#include "physics/xpbd_kernel.h"

namespace morula::MORULA_ISA {

using Sphere = RoundShell<ShellShape::sphere>;
using Ellipsoid = RoundShell<ShellShape::ellipsoid>;
using Planes = PlaneShell<false>;
using PlanesAroundSpheres = PlaneShell<true>;

// [ShellShape]
#define MORULA_IN_SHELLS(drift)                                               \
  {                                                                           \
    drift, driftInShell<drift, Sphere>, driftInShell<drift, Ellipsoid>,       \
        driftInShell<drift, ShellAroundSpheres>, driftInShell<drift, Planes>, \
        driftInShell<drift, PlanesAroundSpheres>                              \
  }
// [evaluation] of a time step.
#define MORULA_FOUR(Shell)                                                               \
  {                                                                                      \
    driftInShell<driftRungeKutta<1>, Shell>, driftInShell<driftRungeKutta<2>, Shell>,    \
        driftInShell<driftRungeKutta<3>, Shell>, driftInShell<driftRungeKutta<4>, Shell> \
  }
// [KickShell]; a sphere is borne as an ellipsoid is.
#define MORULA_KICKS(lacking)                                                                             \
  {                                                                                                       \
    kick<lacking>, kickInShell<kick<lacking>, Ellipsoid>, kickInShell<kick<lacking>, ShellAroundSpheres>, \
        kickInShell<kick<lacking>, Planes>, kickInShell<kick<lacking>, PlanesAroundSpheres>               \
  }
// [ShellShape] of a kernel around surfaces alone.
#define MORULA_AROUND_SURFACES(kernel, first, planes) \
  { kernel<first, NoShell>, kernel<first, Sphere>, kernel<first, Ellipsoid>, nullptr, planes }

extern const PhysicsKernels physics;
const PhysicsKernels physics = {
    .driftVelocityVerlet = MORULA_IN_SHELLS(driftVelocityVerlet),
    .driftThesisVerlet = MORULA_IN_SHELLS(driftThesisVerlet),
    .driftExplicitEuler = MORULA_IN_SHELLS(driftExplicitEuler),
    .driftSymplecticEuler = MORULA_IN_SHELLS(driftSymplecticEuler),
    .driftRungeKutta = {{driftRungeKutta<1>, driftRungeKutta<2>, driftRungeKutta<3>, driftRungeKutta<4>},
                        MORULA_FOUR(Sphere),
                        MORULA_FOUR(Ellipsoid),
                        MORULA_FOUR(ShellAroundSpheres),
                        MORULA_FOUR(Planes),
                        MORULA_FOUR(PlanesAroundSpheres)},
    .driftXpbd = {MORULA_AROUND_SURFACES(driftXpbd, false, (driftXpbd<false, Planes>)),
                  MORULA_AROUND_SURFACES(driftXpbd, true, (driftXpbd<true, Planes>))},
    .endAndDrift = {MORULA_AROUND_SURFACES(endAndDrift, false, nullptr),
                    MORULA_AROUND_SURFACES(endAndDrift, true, nullptr)},
    .endEvaluation = MORULA_KICKS(Kick::none),
    .kickVelocityVerlet = MORULA_KICKS(Kick::half),
    .kickSymplecticEuler = MORULA_KICKS(Kick::whole),
    .findTensions = findTensions<false, false>,
    .findDampedTensions = findTensions<true, false>,
    .findWeightedTensions = {findTensions<false, true>, findTensions<true, true>},
    .accumulateRings = accumulateRings<true>,
    .accumulateAreaVectors = accumulateRings<false>,
    .addPressureForces = addPressureForces<false>,
    .addPressureAndDragForces = addPressureForces<true>,
    .findPressure = findPressure,
    .findShapeForces = {{findShapeForces<false, false>, findShapeForces<false, true>},
                        {findShapeForces<true, false>, findShapeForces<true, true>}},
    .measureSpheres = measureSpheres<false>,
    .measureDraggedSpheres = measureSpheres<true>,
};

}  // namespace morula::MORULA_ISA
