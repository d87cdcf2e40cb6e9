#pragma once
// Ends a run whose numbers are not finite.
#include <cstddef>
#include <span>

#include "state/world.h"

namespace morula {

/// Throws NumericalError if one of these numbers of a cell's state is not finite. The step itself looks at volumes
/// alone: a bad number that they do not show yet reaches them in the next step.
void checkNumbers(const World& world, std::size_t cell, const char* field, std::span<const double> values);
/// Checks all numbers of all cells' bodies in this way.
void checkNumbers(const World& world);

}  // namespace morula
