// Compiled once per instruction set (core/CMakeLists.txt); see physics_dispatch.cpp for the choice.
#include "physics/physics_kernels.h"

#include "physics/bending_kernel.h"
#include "physics/euler_kernel.h"
#include "physics/isolated_kernel.h"
#include "physics/pressure_kernel.h"
#include "physics/relax_kernel.h"
#include "physics/ring_kernel.h"
#include "physics/runge_kutta_kernel.h"
#include "physics/shape_kernel.h"
#include "physics/shell_planes_kernel.h"
#include "physics/sphere_kernel.h"
#include "physics/spring_kernel.h"
#include "physics/verlet_kernel.h"
#include "physics/xpbd_kernel.h"

namespace morula::MORULA_ISA {

// A drift's kernels [ShellShape]. The drift's template arguments before the shape follow its name.
#define MORULA_IN_MESH_SHELLS(drift, ...)                                     \
  drift<__VA_ARGS__ ShellShape::none>, drift<__VA_ARGS__ ShellShape::sphere>, \
      drift<__VA_ARGS__ ShellShape::ellipsoid>, drift<__VA_ARGS__ ShellShape::surface>
#define MORULA_IN_SHELLS(drift)                                                                                  \
  {                                                                                                              \
    MORULA_IN_MESH_SHELLS(drift), driftSpheres<drift<ShellShape::none>>, driftInPlanes<drift<ShellShape::none>>, \
        driftInPlanes<drift<ShellShape::none>, true>                                                             \
  }
// A time step's drifts [evaluation].
#define MORULA_FOUR(shape) \
  { driftRungeKutta<1, shape>, driftRungeKutta<2, shape>, driftRungeKutta<3, shape>, driftRungeKutta<4, shape> }

#define MORULA_FOUR_IN_PLANES(balls)                                \
  {                                                                 \
    driftInPlanes<driftRungeKutta<1, ShellShape::none>, balls>,     \
        driftInPlanes<driftRungeKutta<2, ShellShape::none>, balls>, \
        driftInPlanes<driftRungeKutta<3, ShellShape::none>, balls>, \
        driftInPlanes<driftRungeKutta<4, ShellShape::none>, balls>  \
  }
// A kick's kernels [KickShell].
#define MORULA_KICKS(lacking)                                                                                  \
  {                                                                                                            \
    kick<lacking, ShellShape::none>, kick<lacking, ShellShape::ellipsoid>, kick<lacking, ShellShape::surface>, \
        kickSpheres<kick<lacking, ShellShape::none>>, kickInPlanes<kick<lacking, ShellShape::none>>,           \
        kickInPlanes<kick<lacking, ShellShape::none>, true>                                                    \
  }

extern const PhysicsKernels physics;
const PhysicsKernels physics = {
    .driftVelocityVerlet = MORULA_IN_SHELLS(driftVelocityVerlet),
    .driftThesisVerlet = MORULA_IN_SHELLS(driftThesisVerlet),
    .driftExplicitEuler = MORULA_IN_SHELLS(driftExplicitEuler),
    .driftSymplecticEuler = MORULA_IN_SHELLS(driftSymplecticEuler),
    .driftRungeKutta = {MORULA_FOUR(ShellShape::none),
                        MORULA_FOUR(ShellShape::sphere),
                        MORULA_FOUR(ShellShape::ellipsoid),
                        MORULA_FOUR(ShellShape::surface),
                        {driftSpheres<driftRungeKutta<1, ShellShape::none>>,
                         driftSpheres<driftRungeKutta<2, ShellShape::none>>,
                         driftSpheres<driftRungeKutta<3, ShellShape::none>>,
                         driftSpheres<driftRungeKutta<4, ShellShape::none>>},
                        MORULA_FOUR_IN_PLANES(false),
                        MORULA_FOUR_IN_PLANES(true)},
    .driftXpbd = {{MORULA_IN_MESH_SHELLS(driftXpbd, false, ), nullptr, driftXpbdIn<false, keepAllInPlanes<false>>},
                  {MORULA_IN_MESH_SHELLS(driftXpbd, true, ), nullptr, driftXpbdIn<true, keepAllInPlanes<false>>}},
    .endAndDrift = {{MORULA_IN_MESH_SHELLS(endAndDrift, false, ), nullptr, nullptr},
                    {MORULA_IN_MESH_SHELLS(endAndDrift, true, ), nullptr, nullptr}},
    .endEvaluation = MORULA_KICKS(Kick::none),
    .kickVelocityVerlet = MORULA_KICKS(Kick::half),
    .kickSymplecticEuler = MORULA_KICKS(Kick::whole),
    .findTensions = findTensions<false, false>,
    .findDampedTensions = findTensions<true, false>,
    .findWeightedTensions = {findTensions<false, true>, findTensions<true, true>},
    .accumulateRings = accumulateRings<true>,
    .accumulateAreaVectors = accumulateRings<false>,
    .addBendingForces = addBendingForces,
    .addPressureForces = addPressureForces<false>,
    .addPressureAndDragForces = addPressureForces<true>,
    .findPressure = findPressure,
    .findShapeForces = {{findShapeForces<false, false>, findShapeForces<false, true>},
                        {findShapeForces<true, false>, findShapeForces<true, true>}},
    .measureSpheres = measureSpheres<false>,
    .measureDraggedSpheres = measureSpheres<true>,
    .dampMotion = dampMotion,
};

}  // namespace morula::MORULA_ISA
