#pragma once
// How the processor rounds. Programs and libraries can leave it changed: a library that is linked with
// -ffast-math has every program that loads it flush denormal numbers to zero.

namespace morula {

/// Sets this thread to what "Same bits" in core/README.md says: rounding to nearest, denormal numbers kept,
/// no exceptions. Every program calls it first of all; parallelFor does on its threads.
void setFloatingPoint();

}  // namespace morula
