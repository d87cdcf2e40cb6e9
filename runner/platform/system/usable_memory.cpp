#include "system/usable_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <new>
#include <sstream>
#include <string_view>

#include "files/read_file.h"

namespace morula {
namespace {

constexpr double share = 0.9;

/// [byte] What stands behind the line's name in /proc/meminfo; infinite if it does not say.
double freeOfMachine() {
  std::istringstream file(readHead("/proc/meminfo", 65536));
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name;
    double kilobytes = 0;
    if (words >> name >> kilobytes && name == "MemAvailable:") return 1024 * kilobytes;
  }
  return INFINITY;
}

/// [byte] The only number in a file of the control groups; infinite if it is "max", or not there.
double numberIn(const std::string& file) {
  double number = 0;
  return std::istringstream(readHead(file, 64)) >> number ? number : INFINITY;
}

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
    constexpr std::string_view text = "morula: there is no more memory, and no way on without\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
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
