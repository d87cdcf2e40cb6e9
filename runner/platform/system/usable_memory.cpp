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

/// Reads a number; infinite if the text is none.
double numberFrom(const std::string& text) {
  double number = 0;
  return std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc() ? number : INFINITY;
}

/// Returns the available memory of the machine [byte], from /proc/meminfo; infinite if it is not given.
double freeOfMachine() {
  for (const std::string& line : linesOf(readHead("/proc/meminfo", 65536)))
    if (const auto words = wordsOf(line); words.size() > 1 && words[0] == "MemAvailable:")
      return 1024 * numberFrom(words[1]);
  return INFINITY;
}

/// Returns the only number in a file of the control groups [byte]; infinite if it is "max" or the file does not exist.
double numberIn(const std::string& file) { return numberFrom(readHead(file, 64)); }

/// Returns the free memory of the group at `path` and all above it [byte]. `limit`, `use`: names of a group's files.
double freeBelow(const std::string& root, std::string path, const char* limit, const char* use) {
  double free = INFINITY;
  for (;;) {
    const std::string folder = root + path + "/";
    const double most = numberIn(folder + limit), used = numberIn(folder + use);
    if (!std::isinf(most) && !std::isinf(used)) free = std::min(free, std::max(most - used, 0.0));
    if (path.empty()) return free;
    path.erase(path.rfind('/') == path.npos ? 0 : path.rfind('/'));
  }
}

/// Returns the free memory of this process's control groups [byte]: of version 2, and memory groups of version 1. A
/// container may show its own group as the root.
double freeOfGroups() {
  const std::string root = "/sys/fs/cgroup";
  double free = INFINITY;
  for (const std::string& line : linesOf(readHead("/proc/self/cgroup", 65536))) {
    // "0::/job/step", "9:cpu,memory:/job"
    const auto first = line.find(':'), second = line.find(':', first == line.npos ? first : first + 1);
    if (first == line.npos || second == line.npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    std::string path = line.substr(second + 1);
    if (path == "/") path.clear();
    if (controllers == ",,") free = std::min(free, freeBelow(root, path, "memory.max", "memory.current"));
    else if (controllers.find(",memory,") != controllers.npos)
      free = std::min(free, freeBelow(root + "/memory", path, "memory.limit_in_bytes", "memory.usage_in_bytes"));
  }
  return std::min(free, freeBelow(root, "", "memory.max", "memory.current"));
}

int endCode = 0;
std::terminate_handler otherwise = nullptr;

[[noreturn]] void endWithoutMemory() {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    constexpr std::string_view text = "morula: out of memory; the program ends\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
    std::set_terminate([] { ::_exit(endCode); });  // removeOwnDrafts may lack memory, too
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

double usableMemory() { return share * std::min(freeOfMachine(), freeOfGroups()); }

}  // namespace morula
