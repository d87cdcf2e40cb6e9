// Compiled once per instruction set (core/CMakeLists.txt); see physics_dispatch.cpp for the choice.
#include "physics/physics_kernels.h"

#include "physics/pressure_kernel.h"
#include "physics/ring_kernel.h"
#include "physics/spring_kernel.h"
#include "physics/verlet_kernel.h"

namespace morula::MORULA_ISA {

extern const PhysicsKernels physics;
const PhysicsKernels physics = {
    {driftVelocityVerlet<ShellShape::none>, driftVelocityVerlet<ShellShape::sphere>,
     driftVelocityVerlet<ShellShape::ellipsoid>},
    {driftThesisVerlet<ShellShape::none>, driftThesisVerlet<ShellShape::sphere>,
     driftThesisVerlet<ShellShape::ellipsoid>},
    {kick<Integrator::velocityVerlet, false>, kick<Integrator::velocityVerlet, true>},
    {kick<Integrator::thesisVerlet, false>, kick<Integrator::thesisVerlet, true>},
    findSpringCoefficients<false>,
    findSpringCoefficients<true>,
    gatherRings,
    addPressureForces<false>,
    addPressureForces<true>,
};

}  // namespace morula::MORULA_ISA
