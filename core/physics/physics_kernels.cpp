// Compiled once per instruction set (core/CMakeLists.txt); see physics_dispatch.cpp for the choice.
#include "physics/physics_kernels.h"

#include "physics/euler_kernel.h"
#include "physics/isolated_kernel.h"
#include "physics/pressure_kernel.h"
#include "physics/ring_kernel.h"
#include "physics/runge_kutta_kernel.h"
#include "physics/shape_kernel.h"
#include "physics/sphere_kernel.h"
#include "physics/spring_kernel.h"
#include "physics/verlet_kernel.h"
#include "physics/xpbd_kernel.h"

namespace morula::MORULA_ISA {

// [ShellShape] of a drift whose template arguments before the shape are the ones that follow its name.
#define MORULA_IN_MESH_SHELLS(drift, ...)                                     \
  drift<__VA_ARGS__ ShellShape::none>, drift<__VA_ARGS__ ShellShape::sphere>, \
      drift<__VA_ARGS__ ShellShape::ellipsoid>
#define MORULA_IN_SHELLS(drift) \
  { MORULA_IN_MESH_SHELLS(drift), driftSpheres<drift<ShellShape::none>> }
// [evaluation] of a time step.
#define MORULA_FOUR(shape)                                                           \
  {                                                                                  \
    driftRungeKutta<1, shape>, driftRungeKutta<2, shape>, driftRungeKutta<3, shape>, \
        driftRungeKutta<4, shape>                                                    \
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
                        {driftSpheres<driftRungeKutta<1, ShellShape::none>>,
                         driftSpheres<driftRungeKutta<2, ShellShape::none>>,
                         driftSpheres<driftRungeKutta<3, ShellShape::none>>,
                         driftSpheres<driftRungeKutta<4, ShellShape::none>>}},
    .driftXpbd = {{MORULA_IN_MESH_SHELLS(driftXpbd, false, )}, {MORULA_IN_MESH_SHELLS(driftXpbd, true, )}},
    .endAndDrift = {{MORULA_IN_MESH_SHELLS(endAndDrift, false, )},
                    {MORULA_IN_MESH_SHELLS(endAndDrift, true, )}},
    .endEvaluation = {kick<Kick::none, false>, kick<Kick::none, true>, kickSpheres<kick<Kick::none, false>>},
    .kickVelocityVerlet = {kick<Kick::half, false>, kick<Kick::half, true>,
                           kickSpheres<kick<Kick::half, false>>},
    .kickSymplecticEuler = {kick<Kick::whole, false>, kick<Kick::whole, true>,
                            kickSpheres<kick<Kick::whole, false>>},
    .findTensions = findTensions<false>,
    .findDampedTensions = findTensions<true>,
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
