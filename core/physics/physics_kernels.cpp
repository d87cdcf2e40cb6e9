// Compiled once per instruction set (core/CMakeLists.txt); see physics_dispatch.cpp for the choice.
#include "physics/physics_kernels.h"

#include "physics/euler_kernel.h"
#include "physics/lone_kernel.h"
#include "physics/pressure_kernel.h"
#include "physics/ring_kernel.h"
#include "physics/runge_kutta_kernel.h"
#include "physics/shape_kernel.h"
#include "physics/sphere_kernel.h"
#include "physics/spring_kernel.h"
#include "physics/verlet_kernel.h"
#include "physics/xpbd_kernel.h"

namespace morula::MORULA_ISA {

extern const PhysicsKernels physics;
const PhysicsKernels physics = {
    {driftVelocityVerlet<ShellShape::none>, driftVelocityVerlet<ShellShape::sphere>,
     driftVelocityVerlet<ShellShape::ellipsoid>, driftSpheres<driftVelocityVerlet<ShellShape::none>>},
    {driftThesisVerlet<ShellShape::none>, driftThesisVerlet<ShellShape::sphere>,
     driftThesisVerlet<ShellShape::ellipsoid>, driftSpheres<driftThesisVerlet<ShellShape::none>>},
    {driftExplicitEuler<ShellShape::none>, driftExplicitEuler<ShellShape::sphere>,
     driftExplicitEuler<ShellShape::ellipsoid>, driftSpheres<driftExplicitEuler<ShellShape::none>>},
    {driftSymplecticEuler<ShellShape::none>, driftSymplecticEuler<ShellShape::sphere>,
     driftSymplecticEuler<ShellShape::ellipsoid>, driftSpheres<driftSymplecticEuler<ShellShape::none>>},
    {{driftRungeKutta<1, ShellShape::none>, driftRungeKutta<2, ShellShape::none>,
      driftRungeKutta<3, ShellShape::none>, driftRungeKutta<4, ShellShape::none>},
     {driftRungeKutta<1, ShellShape::sphere>, driftRungeKutta<2, ShellShape::sphere>,
      driftRungeKutta<3, ShellShape::sphere>, driftRungeKutta<4, ShellShape::sphere>},
     {driftRungeKutta<1, ShellShape::ellipsoid>, driftRungeKutta<2, ShellShape::ellipsoid>,
      driftRungeKutta<3, ShellShape::ellipsoid>, driftRungeKutta<4, ShellShape::ellipsoid>},
     {driftSpheres<driftRungeKutta<1, ShellShape::none>>, driftSpheres<driftRungeKutta<2, ShellShape::none>>,
      driftSpheres<driftRungeKutta<3, ShellShape::none>>,
      driftSpheres<driftRungeKutta<4, ShellShape::none>>}},
    {{driftXpbd<false, ShellShape::none>, driftXpbd<false, ShellShape::sphere>,
      driftXpbd<false, ShellShape::ellipsoid>},
     {driftXpbd<true, ShellShape::none>, driftXpbd<true, ShellShape::sphere>,
      driftXpbd<true, ShellShape::ellipsoid>}},
    {{endAndDrift<false, ShellShape::none>, endAndDrift<false, ShellShape::sphere>,
      endAndDrift<false, ShellShape::ellipsoid>},
     {endAndDrift<true, ShellShape::none>, endAndDrift<true, ShellShape::sphere>,
      endAndDrift<true, ShellShape::ellipsoid>}},
    {kick<Kick::none, false>, kick<Kick::none, true>, kickSpheres<kick<Kick::none, false>>},
    {kick<Kick::half, false>, kick<Kick::half, true>, kickSpheres<kick<Kick::half, false>>},
    {kick<Kick::whole, false>, kick<Kick::whole, true>, kickSpheres<kick<Kick::whole, false>>},
    findSpringCoefficients<false>,
    findSpringCoefficients<true>,
    gatherRings<true>,
    gatherRings<false>,
    addPressureForces<false>,
    addPressureForces<true>,
    findPressure,
    {{findShapeForces<false, false>, findShapeForces<false, true>},
     {findShapeForces<true, false>, findShapeForces<true, true>}},
    measureSpheres<false>,
    measureSpheres<true>,
};

}  // namespace morula::MORULA_ISA
