#pragma once
// Output: data on stdout, messages on stderr. Only console.cpp writes to either. Every text passes through
// `printable`, because texts hold names, paths and messages that come from the files of others.
#include <chrono>
#include <iosfwd>
#include <string>
#include <vector>

#include "system/json.h"

namespace morula {

/// Data for people or programs, on stdout.
void print(const std::string& text);
/// Bytes for another program, on stdout, as they are.
void printBytes(const std::string& bytes);
/// One JSON object on stdout, with "morula": 1 in front.
void printJson(const Json& members);

/// A remark on stderr; not said when `quiet`.
void tell(const std::string& text, bool quiet);
/// "morula: …" on stderr.
void tellError(const std::string& text);
/// Lines that begin with "file:line:column:", as editors and other programs read them.
void tellInputError(const std::string& text);

/// Prints warnings on what may not be meant: "warning: file:line:column: …"; nothing when `quiet`.
void tellWarnings(const std::vector<std::string>& lines, bool quiet);

/// The streams by which a worker that this program has started reads its question and writes its answer.
std::istream& questionStream();
std::ostream& answerStream();
/// Throws FileError unless all that was printed has arrived: a full disk is no success.
void flushOutput();
/// Makes sure that files which are opened later do not become standard input, output or error, where those are closed.
void reserveStandardStreams();

/// How far something has come: a line that is rewritten on a terminal, otherwise a line every 30 seconds.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Returns true if it is time to show something, by the clock.
  bool isDue() const;
  void show(const std::string& text);
  /// Removes what `show` left on a terminal.
  void clear();
  /// "  [====    ]  42 %" of a share from 0 to 1; the bar only on a terminal.
  std::string bar(double share) const;

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, terminal_, shown_ = false;
  Clock::time_point next_;
};

/// [s] "0:42", "1:05:00".
std::string formatDuration(double seconds);

}  // namespace morula
