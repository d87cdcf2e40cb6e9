#pragma once
// The surface that contacts act on, for those who measure; the step finds it in surface_kernel.h.
#include "contacts/contacts.h"
#include "mesh/mesh.h"

namespace morula {

/// [length] A cell's mesh where contacts act on it: of the pair law y = x + λ U − γ δ n of each vertex, of another law,
/// of none (null) and of spheres as others see it (takeSurface).
Mesh takeContactSurface(const Contacts* contacts, const Bodies& bodies, int slot);

}  // namespace morula
