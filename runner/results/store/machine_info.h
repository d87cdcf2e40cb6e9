#pragma once
// The machine and the time of a run. They are only recorded; no result may depend on them.
#include <string>

namespace morula {

struct MachineInfo {
  std::string cpu;            // "AMD EPYC 7B13"
  std::string kernel;         // "Linux 6.1.0-18-amd64 x86_64"
  std::string features;       // features of the processor that arithmetic can depend on: "avx2 fma sse2 …"
  std::string fpEnvironment;  // floating-point settings of this thread: "nearest, denormals kept, MXCSR 0x1f80"
};

/// Reads the machine's description; a part that cannot be read is "unknown".
MachineInfo machineInfo();

/// Returns 32 hexadecimal digits over the file of the running program; "unknown" if it cannot be read.
std::string binaryHash();

/// Returns the machine's name in its network; "unknown" if it has none.
std::string hostName();

/// Returns the present time as "2008-06-17T12:34:56Z".
std::string utcNow();

}  // namespace morula
