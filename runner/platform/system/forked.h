#pragma once
// A part of this program's work in a separate process, made by fork. Damage to its memory, or its end, does not affect
// the others. Fork while the process has only one thread.
#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "files/descriptor.h"

namespace morula {

struct ForkedLimits {
  std::optional<double> cpuSeconds = {};  // [s] max CPU time, rounded up to whole seconds; then SIGXCPU
  std::optional<std::uint64_t> memory =
      {};  // [byte] max address space beyond this process's; beyond it allocations fail
};

/// The answer of a forked process: an exit code, and a text of at most 16 KiB for the process that began it.
struct ForkedAnswer {
  int code = 0;
  std::string text = {};
};

struct ForkedEnd {
  ForkedAnswer answer;
  int signal = 0;               // the signal that ended it; 0: it ended by itself
  double cpuSeconds = 0;        // [s]
  std::uint64_t maxMemory = 0;  // [byte] resident, including memory shared with this process
};

class Forked {
 public:
  /// Begins `work`, which must not throw, print or leave by other ways than its return. If this process dies, so does
  /// the new one. Throws FileError if no process can be made.
  Forked(const ForkedLimits& limits, const std::function<ForkedAnswer()>& work);
  /// Ends the process at once, if it still runs.
  ~Forked();
  Forked(Forked&& other) noexcept;
  Forked(const Forked&) = delete;
  Forked& operator=(const Forked&) = delete;

  /// Waits for the end of the process.
  ForkedEnd wait();
  void stop(int signal);

 private:
  friend std::vector<std::size_t> endedAmong(const std::vector<Forked*>& processes, double seconds);
  pid_t process_ = -1;
  Descriptor answer_{-1};  // a pipe that ends with the process
};

/// Waits until one of the processes has an answer or has ended, a signal has come, or `seconds` [s] have passed.
/// Returns the places of the processes that have ended, which have then been waited for.
std::vector<std::size_t> endedAmong(const std::vector<Forked*>& processes, double seconds);

/// Removes the memory limit in a forked process, so that computed results can be written.
void liftMemoryLimit();

/// Returns the name of a signal: "SIGSEGV", …; "signal 40" for others.
std::string signalName(int signal);

}  // namespace morula
