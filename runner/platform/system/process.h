#pragma once
// Parts that child_process.cpp and forked.cpp share: pipes, limits, and waiting for a process.
#include <sys/resource.h>
#include <sys/types.h>

#include <cstdint>
#include <string>

#include "base/error.h"
#include "files/descriptor.h"

namespace morula {

/// Returns the error that a process could not be made or waited for, with the reason in errno.
FileError processError(const std::string& what);

/// A pipe whose ends are both closed when another program is started.
struct Pipe {
  Descriptor read, write;
};
Pipe makePipe();

/// Reads until the other end of a pipe is closed.
std::string readToEnd(const Descriptor& from);

/// Sets a limit of this process, as far as its hard limit allows.
void setLimit(decltype(RLIMIT_CPU) what, rlim_t most);

struct ProcessEnd {
  int status = 0;  // the status from waitpid
  double cpuSeconds = 0;
  std::uint64_t maxMemory = 0;  // [byte] resident
};
ProcessEnd waitFor(pid_t process);

}  // namespace morula
