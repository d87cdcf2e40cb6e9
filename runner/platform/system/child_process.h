#pragma once
// Another program, or this one once more, in a process of its own: a text on its stdin, its answer on its
// stdout.
#include <string>
#include <vector>

#include "system/process.h"

namespace morula {

struct ChildOptions {
  std::string input = {};  // for its stdin, which then ends
  int cpuSeconds = 0;      // after so much CPU time the kernel ends it: what loops for ever does not stop us
  bool silent = false;     // its stderr goes nowhere; otherwise to ours
  bool errorsToo = false;  // what it writes to stderr is part of what it said
};

struct ChildEnd : ProcessEnd {
  std::string said;  // all that it wrote, also if it did not end well

  bool well() const;         // it ended by itself, with code 0
  bool notStarted() const;   // there is no such program, or none that can be run: code 127, as in a shell
  bool outOfTime() const;    // its CPU time was used up
  int code() const;          // its exit code, or 128 + the signal that ended it
  std::string text() const;  // "ended with code 3", "was ended by signal 9"
};

/// Starts command[0], looked for in PATH if its name holds no slash, with the other words as its arguments,
/// and waits for its end. Throws FileError if no process can be made.
ChildEnd runChild(const std::vector<std::string>& command, const ChildOptions& options = {});

/// The running program's own file.
std::string ownProgram();

}  // namespace morula
