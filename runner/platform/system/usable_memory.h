#pragma once
// The memory that a run may take on this machine.

#include <cstdint>

namespace morula {

/// Returns nine tenths of the free memory of this machine, or of this process's control group [byte]. An unknown amount
/// counts as infinite.
double usableMemory();

/// Returns the max resident memory of this process so far [byte].
std::uint64_t peakMemory();

/// Sets the exit code for a lack of memory in code that cannot throw, as libraries' destructors. The process then says
/// so and ends at once; unfinished writes are drafts, or transactions that are undone.
void endOutOfMemoryWith(int code);

/// The end of a message about memory that could not be had.
inline constexpr const char* outOfMemoryRemedy =
    "stop earlier, take fewer cells or a coarser physics.mesh, or give a --memory-limit below what is free";

}  // namespace morula
