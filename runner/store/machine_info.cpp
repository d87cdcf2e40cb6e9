#include "store/machine_info.h"

#include <sys/utsname.h>

#include <ctime>
#include <fstream>

namespace morula {

namespace {

/// x86 names its processor in "model name"; others give no name
/// there, so only the architecture (in `kernel`) is known.
std::string cpuName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name"))
      if (const auto colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
  return "unknown";
}

std::string kernelName() {
  utsname u{};
  if (uname(&u) != 0) return "unknown";
  return std::string(u.sysname) + ' ' + u.release + ' ' + u.machine;
}

}  // namespace

MachineInfo machineInfo() {
  static const MachineInfo machine{cpuName(), kernelName()};
  return machine;
}

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  const std::size_t size = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {text, size};
}

}  // namespace morula
