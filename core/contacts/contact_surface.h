#pragma once
// The surface that contacts act on, for measures; the step finds it in surface_kernel.h.
#include "contacts/contacts.h"
#include "mesh/mesh.h"

namespace morula {

/// Returns a cell's mesh [length] where contacts act on it: with the pair law y = x + λ U − γ δ n of each vertex; with
/// another law, without contacts (null) and for spheres takeSurface.
Mesh takeContactSurface(const Contacts* contacts, const Bodies& bodies, int slot);

}  // namespace morula
