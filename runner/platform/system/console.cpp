#include "system/console.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "base/error.h"
#include "files/printable.h"

namespace morula {
namespace {

/// Returns true if stderr is a terminal on which lines can be rewritten.
bool isTerminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && kind && std::string(kind) != "dumb";
}

std::string red(const std::string& text) {
  const char* plain = std::getenv("NO_COLOR");
  return isTerminal() && !(plain && *plain) ? "\x1b[31m" + text + "\x1b[0m" : text;
}

/// Returns a message with very long words cut, so that a user's text cannot hide the rest.
std::string message(const std::string& text) {
  constexpr std::size_t most = 400, shown = 100;
  std::string all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    std::size_t length = end - at;
    if (length > most) {
      length = shown;
      while ((text[at + length] & 0xC0) == 0x80) --length;  // a character is not cut
    }
    all += text.substr(at, length);
    if (length < end - at) all += "… (" + std::to_string(end - at) + " bytes)";
    if (end < text.size()) all += text[end];
    at = end + 1;
  }
  return printable(all);
}

}  // namespace

void print(const std::string& text) { std::cout << printable(text); }

void printBytes(const std::string& bytes) { std::cout << bytes; }

void printJson(const Json& members) {
  Json object{{"morula", 1}};
  object.update(members);
  print(jsonText(object, 2) + "\n");
}

void tell(const std::string& text, bool quiet) {
  if (!quiet) std::cerr << message(text) << "\n";
}

void tellError(const std::string& text) { std::cerr << red("morula: ") << message(text) << "\n"; }

void tellInputError(const std::string& text) { std::cerr << message(text) << "\n"; }

std::istream& questionStream() { return std::cin; }

std::ostream& answerStream() { return std::cout; }

void flushOutput() {
  if (std::cout.flush().fail()) throw FileError("standard output cannot be written");
}

void reserveStandardStreams() {
  // Opened for reading only, so that a write to a closed output fails.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", O_RDONLY) != stream)
      throw FileError("/dev/null cannot be opened in place of a closed standard stream");
}

void tellWarnings(const std::vector<std::string>& lines, bool quiet) {
  for (const auto& line : lines) tell("warning: " + line, quiet);
}

using namespace std::chrono_literals;
constexpr const char* clearLine = "\r\x1b[K";

ProgressLine::ProgressLine(bool quiet)
    : quiet_(quiet), terminal_(isTerminal()), next_(Clock::now() + (terminal_ ? 300ms : 30000ms)) {}

bool ProgressLine::isDue() const { return !quiet_ && Clock::now() >= next_; }

void ProgressLine::show(const std::string& text) {
  if (terminal_) std::cerr << clearLine << printableLine(text) << std::flush;
  else std::cerr << printableLine(text) << "\n";
  shown_ = true;
  next_ = Clock::now() + (terminal_ ? 200ms : 30000ms);
}

void ProgressLine::clear() {
  if (shown_ && terminal_) std::cerr << clearLine << std::flush;
  shown_ = false;
}

std::string ProgressLine::bar(double share) const {
  constexpr int width = 24;
  const int full = static_cast<int>(std::clamp(share, 0.0, 1.0) * width);
  return (terminal_ ? fmt::format("  [{:=<{}}{:<{}}]", "", full, "", width - full) : "") +
         fmt::format("  {:.0f} %", 100 * share);
}

std::string formatDuration(double seconds) {
  const auto all = static_cast<long long>(std::clamp(seconds, 0.0, 3.6e9) + 0.5);
  const auto hours = all / 3600, minutes = all / 60 % 60, rest = all % 60;
  return hours ? fmt::format("{}:{:02}:{:02}", hours, minutes, rest) : fmt::format("{}:{:02}", minutes, rest);
}

}  // namespace morula
