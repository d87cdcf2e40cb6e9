#pragma once
// Output: data on stdout, messages on stderr. Only console.cpp writes to either. Every text passes through `printable`,
// because texts hold names, paths and messages from other people's files.
#include <chrono>
#include <iosfwd>
#include <string>
#include <vector>

#include "system/json.h"

namespace morula {

/// Prints data for people or programs, on stdout.
void print(const std::string& text);
/// Prints bytes for another program, unchanged, on stdout.
void printBytes(const std::string& bytes);
/// Prints one JSON object on stdout, with "morula": 1 in front.
void printJson(const Json& members);

/// Prints a remark on stderr; nothing when `quiet`.
void tell(const std::string& text, bool quiet);
/// Prints "morula: …" on stderr.
void tellError(const std::string& text);
/// Prints lines that begin with "file:line:column:", as editors and other programs read them.
void tellInputError(const std::string& text);

/// Prints warnings on input that is probably a mistake: "warning: file:line:column: …"; nothing when `quiet`.
void tellWarnings(const std::vector<std::string>& lines, bool quiet);

/// The streams from which a worker started by this program reads its question, and to which it writes its answer.
std::istream& questionStream();
std::ostream& answerStream();
/// Flushes stdout. Throws FileError if output was lost: a full disk is no success.
void flushOutput();
/// Opens the standard streams that are closed, so that files opened later do not take their numbers.
void reserveStandardStreams();

/// A progress line: rewritten on a terminal, otherwise a new line every 30 seconds.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Returns true if, by the clock, progress should be shown again.
  bool isDue() const;
  void show(const std::string& text);
  /// Removes the line of `show` from a terminal.
  void clear();
  /// Returns "  [====    ]  42 %" for a share from 0 to 1; the bar only on a terminal.
  std::string bar(double share) const;

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, terminal_, shown_ = false;
  Clock::time_point next_;
};

/// Returns a duration [s] as "0:42", "1:05:00".
std::string formatDuration(double seconds);

}  // namespace morula
