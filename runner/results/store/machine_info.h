#pragma once
// The machine of a run and the time. They are for the record only: nothing here may change a result.
#include <string>

namespace morula {

struct MachineInfo {
  std::string cpu;            // "AMD EPYC 7B13"
  std::string kernel;         // "Linux 6.1.0-18-amd64 x86_64"
  std::string features;       // of the processor, those that arithmetic can depend on: "avx2 fma sse2 …"
  std::string fpEnvironment;  // of this thread: "nearest, denormals kept, MXCSR 0x1f80"
};

/// Reads the machine's description; what cannot be read is "unknown".
MachineInfo machineInfo();

/// 32 hexadecimal digits over the file of the running program; "unknown" if it cannot be read.
std::string binaryHash();

/// The machine's name in its network; "unknown" if it has none.
std::string hostName();

/// Now, as "2008-06-17T12:34:56Z".
std::string utcNow();

}  // namespace morula
