#pragma once
// This program once more in a process of its own: one question on its stdin, one answer on its stdout.
#include <string>

namespace morula {

struct ChildEnd {
  std::string said;  // all that it wrote, also if it did not end well
  int status = 0;    // as waitpid has it

  bool well() const;         // it ended by itself, with code 0
  bool outOfTime() const;    // its CPU time was used up
  std::string text() const;  // "ended with code 3", "was ended by signal 9"
};

/// Starts `program` with the argument `verb`, hands the text over and waits. With `cpuSeconds` the kernel
/// ends it after so much CPU time: what loops for ever does not stop us. Throws FileError if no process can
/// be made.
ChildEnd talkToChild(const std::string& program, const char* verb, const std::string& text,
                     int cpuSeconds = 0);

/// The running program's own file.
std::string ownProgram();

}  // namespace morula
