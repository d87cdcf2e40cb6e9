#pragma once
// Names the part of a scene that bounds its automatic time step.
#include <string>

#include "state/world.h"

namespace morula {

/// The part without which the time step could be longest.
struct BindingLimit {
  std::string part;   // "the damping of contacts"
  double factor = 1;  // [1] the stability limit without this part over the present one
};

/// Finds what binds the time step of the world as it is, by leaving out one part after the other. The world is restored.
/// Requires bodies and at least one cell.
BindingLimit findBindingLimit(World& world);

}  // namespace morula
