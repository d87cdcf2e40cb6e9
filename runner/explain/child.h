#pragma once
// Another program's answer.
#include <optional>
#include <string>
#include <vector>

namespace morula {

struct Answer {
  int exitCode = 0;
  std::string output;  // what it wrote to stdout
};

/// Starts a program (looked for in PATH if its name holds no slash), waits, and returns what it said; its
/// messages go to our stderr, or nowhere with `silent`. Nothing if it cannot be started.
std::optional<Answer> ask(const std::vector<std::string>& command, bool silent);

}  // namespace morula
