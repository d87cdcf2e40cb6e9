#pragma once
// A part of this program's work in a process of its own, made by fork: whatever it does to its memory, and however it
// ends, the others go on. To be made while the process has one thread only.
#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "files/descriptor.h"

namespace morula {

struct ForkedLimits {
  std::optional<double> cpuSeconds = {};  // [s] of CPU time, in whole seconds upwards: then SIGXCPU ends it
  std::optional<std::uint64_t> memory =
      {};  // [byte] of address space beyond this process's: then there is no more memory
};

/// The answer of a forked process: an exit code, and a text of at most 16 KiB for the process that began it.
struct ForkedAnswer {
  int code = 0;
  std::string text = {};
};

struct ForkedEnd {
  ForkedAnswer answer;
  int signal = 0;               // that ended it; 0: it ended by itself
  double cpuSeconds = 0;        // [s]
  std::uint64_t maxMemory = 0;  // [byte] resident, what it shares with this process among it
};

class Forked {
 public:
  /// Begins `work`, which must not throw, print or return to its callers by other ways. If this process dies, so does
  /// the new one. Throws FileError if no process can be made.
  Forked(const ForkedLimits& limits, const std::function<ForkedAnswer()>& work);
  /// Ends it at once, if it still runs.
  ~Forked();
  Forked(Forked&& other) noexcept;
  Forked(const Forked&) = delete;
  Forked& operator=(const Forked&) = delete;

  /// Waits for its end.
  ForkedEnd wait();
  void stop(int signal);

 private:
  friend std::vector<std::size_t> endedAmong(const std::vector<Forked*>& processes, double seconds);
  pid_t process_ = -1;
  Descriptor answer_{-1};  // a pipe that ends with the process
};

/// Waits until one of the processes has something to say or has ended, a signal has come, or so much time [s] has
/// passed. Waits for processes and returns the places of those that have ended.
std::vector<std::size_t> endedAmong(const std::vector<Forked*>& processes, double seconds);

/// In such a process: memory is not limited any more, so that what has been computed can be written.
void liftMemoryLimit();

/// "SIGSEGV", …; "signal 40" for others.
std::string signalName(int signal);

}  // namespace morula
