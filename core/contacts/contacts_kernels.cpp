// Compiled once per instruction set (core/CMakeLists.txt); see contacts_dispatch.cpp for the choice.
#include "contacts/contacts_kernels.h"

#include "contacts/acting_kernel.h"
#include "contacts/crowding_kernel.h"
#include "contacts/pair_law_kernel.h"
#include "contacts/rows_kernel.h"
#include "contacts/sphere_law_kernel.h"
#include "contacts/thesis_law_kernel.h"

namespace morula::MORULA_ISA {

extern const ContactKernels contacts;
const ContactKernels contacts = {
    .takeSnapshot = takeSnapshot,
    .takeSphereSnapshot = takeSphereSnapshot,
    .takeSurface = takeSurface<false>,
    .takeSurfaceAndCount = takeSurface<true>,
    .addPairForces = addPairForces<false, false>,
    .addPairForcesWithViscosity = addPairForces<true, false>,
    .addThesisForces = addThesisForces,
    .addSphereForces = addSphereForces<false, false>,
    .addSphereForcesWithViscosity = addSphereForces<true, false>,
    .addStickyPairForces = addPairForces<false, true>,
    .addStickyPairForcesWithViscosity = addPairForces<true, true>,
    .addStickySphereForces = addSphereForces<false, true>,
    .addStickySphereForcesWithViscosity = addSphereForces<true, true>,
    .findCrowding = findCrowding,
    .findSteepest = findSteepest,
    .findActing = findActing,
};

}  // namespace morula::MORULA_ISA
