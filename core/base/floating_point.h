#pragma once
// The processor's rounding mode. Programs and libraries can change it: a library linked with -ffast-math makes every
// program that loads it flush denormal numbers to zero.

namespace morula {

/// Sets this thread to the mode of "Same bits" in core/README.md: rounding to nearest, denormal numbers kept, no
/// exceptions. Every program calls this first of all; parallelFor calls it on its threads.
void setFloatingPoint();

}  // namespace morula
