#pragma once
// How much memory a run may take, on this machine and as the user says.
#include <string>

namespace morula::cli {

/// [byte] Nine tenths of what this machine, or the group of processes that this one is in, has free: what is
/// not known does not limit.
double usableMemory();

/// [byte] "500M", "8G", "1.5G", "200000000". Throws UsageError that names the option.
double sizeOption(const std::string& option, const std::string& text);

/// The end of a message about memory that was not to be had.
inline constexpr const char* outOfMemoryRemedy =
    "stop earlier, take fewer cells or a coarser physics.mesh, or give a --memory-limit below what is free";

}  // namespace morula::cli
