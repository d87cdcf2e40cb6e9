#include "system/usable_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include "files/draft.h"
#include "files/read_file.h"
#include "files/text.h"

namespace morula {
namespace {

constexpr double share = 0.9;

/// Infinite where it is none.
double numberFrom(const std::string& text) {
  double number = 0;
  return std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc() ? number : INFINITY;
}

/// [byte] What stands behind the line's name in /proc/meminfo; infinite if it does not say.
double freeOfMachine() {
  for (const std::string& line : linesOf(readHead("/proc/meminfo", 65536)))
    if (const auto words = wordsOf(line); words.size() > 1 && words[0] == "MemAvailable:")
      return 1024 * numberFrom(words[1]);
  return INFINITY;
}

/// [byte] The only number in a file of the control groups; infinite if it is "max", or not there.
double numberIn(const std::string& file) { return numberFrom(readHead(file, 64)); }

/// Control groups of version 2, as containers see their own.
double freeOfGroup() {
  const double most = numberIn("/sys/fs/cgroup/memory.max");
  const double used = numberIn("/sys/fs/cgroup/memory.current");
  return std::isinf(most) || std::isinf(used) ? INFINITY : std::max(most - used, 0.0);
}

int endCode = 0;
std::terminate_handler otherwise = nullptr;

[[noreturn]] void endWithoutMemory() {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    constexpr std::string_view text = "morula: out of memory; the program ends\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
    std::set_terminate([] { ::_exit(endCode); });  // that may find no memory either
    try {
      removeOwnDrafts();
    } catch (...) {}
    ::_exit(endCode);
  } catch (...) { otherwise(); }
  std::abort();
}

}  // namespace

void endOutOfMemoryWith(int code) {
  endCode = code;
  if (!otherwise) otherwise = std::set_terminate(endWithoutMemory);
}

std::uint64_t peakMemory() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  return static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
}

double usableMemory() { return share * std::min(freeOfMachine(), freeOfGroup()); }

}  // namespace morula
