#pragma once
// How much memory a run may take on this machine.

#include <cstdint>

namespace morula {

/// [byte] Nine tenths of what this machine, or the group of processes that this one is in, has free: what is
/// not known does not limit.
double usableMemory();

/// [byte] The most that this process has had resident so far.
std::uint64_t peakMemory();

/// From now on, where memory ends in code that cannot throw, as libraries' destructors, the process says so and ends at
/// once with this code: what it was writing is a draft, or a transaction that is undone.
void endOutOfMemoryWith(int code);

/// The end of a message about memory that was not to be had.
inline constexpr const char* outOfMemoryRemedy =
    "stop earlier, take fewer cells or a coarser physics.mesh, or give a --memory-limit below what is free";

}  // namespace morula
