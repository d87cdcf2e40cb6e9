#pragma once
// Runs another program, or this one again, in a separate process: a text on its stdin, its answer on its stdout.
#include <string>
#include <vector>

#include "system/process.h"

namespace morula {

struct ChildOptions {
  std::string input = {};  // the whole text for its stdin
  int cpuSeconds = 0;      // max CPU time [s], after which the kernel ends the process; 0: no limit
  bool silent = false;     // true: its stderr is dropped; false: it goes to this process's stderr
  bool errorsToo = false;  // true: its stderr is part of `said`
};

struct ChildEnd : ProcessEnd {
  std::string said;  // the whole output, also of a process that failed

  bool well() const;         // true if the process ended by itself, with code 0
  bool notStarted() const;   // true if the program does not exist or cannot run: code 127, as in a shell
  bool outOfTime() const;    // true if its CPU time was used up
  int code() const;          // its exit code, or 128 + the signal that ended it
  std::string text() const;  // "ended with code 3", "was ended by signal 9"
};

/// Starts command[0], searched in PATH if its name holds no slash, with the other words as its arguments. Waits for its
/// end. Throws FileError if no process can be made.
ChildEnd runChild(const std::vector<std::string>& command, const ChildOptions& options = {});

/// Returns the file of the running program.
std::string ownProgram();

}  // namespace morula
