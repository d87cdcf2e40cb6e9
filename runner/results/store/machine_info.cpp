#include "store/machine_info.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <cfenv>
#include <ctime>
#include <limits>
#include <set>

#include "base/error.h"
#include "base/hash.h"
#include "files/read_file.h"
#include "files/text.h"
#include "store/build_info.h"
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace morula {
namespace {

/// Returns the value of the first line of /proc/cpuinfo that begins with `name`. x86 names its processor in "model
/// name"; other processors are known only by their architecture (in `kernel`).
std::string cpuInfo(const std::string& name) {
  for (const std::string& line : linesOf(readHead("/proc/cpuinfo", 1 << 20)))
    if (line.starts_with(name))
      if (const auto colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
  return "unknown";
}

std::string cpuFeatures() {
  std::string all = cpuInfo("flags");               // x86
  if (all == "unknown") all = cpuInfo("Features");  // ARM
  std::set<std::string> features;
  for (const std::string& word : wordsOf(all))
    for (const char* kind : {"sse", "ssse", "avx", "fma", "f16c", "amx", "fp", "asimd", "sve"})
      if (word.starts_with(kind)) features.insert(word);
  std::string text;
  for (const std::string& feature : features) text += (text.empty() ? "" : " ") + feature;
  return text.empty() ? "unknown" : text;
}

std::string roundingName() {
  switch (std::fegetround()) {
    case FE_TONEAREST: return "nearest";
    case FE_UPWARD: return "upward";
    case FE_DOWNWARD: return "downward";
    case FE_TOWARDZERO: return "toward zero";
    default: return "rounding unknown";
  }
}

std::string fpEnvironment() {
  volatile double smallest = std::numeric_limits<double>::min();  // volatile: this processor must compute it
  std::string text = roundingName() + (smallest / 2 > 0 ? ", denormals kept" : ", denormals flushed");
#ifdef __SSE2__
  constexpr unsigned flags = 0x3f;  // exceptions so far, which are no part of the settings
  text += fmt::format(", MXCSR {:#x}", _mm_getcsr() & ~flags);
#endif
  return text;
}

std::string kernelName() {
  utsname u{};
  if (uname(&u) != 0) return "unknown";
  return std::string(u.sysname) + ' ' + u.release + ' ' + u.machine;
}

}  // namespace

MachineInfo machineInfo() {
  static const MachineInfo machine{cpuInfo("model name"), kernelName(), cpuFeatures(), fpEnvironment()};
  return machine;
}

std::string binaryHash() {
  static const std::string hash = [] {
    Hasher hasher;
    try {
      readPieces("/proc/self/exe", [&](std::string_view piece) { hasher.addPiece(piece); });
    } catch (const FileError&) { return std::string("unknown"); }
    return hasher.digest().text();
  }();
  return hash;
}

std::string hostName() {
  utsname u{};
  return uname(&u) == 0 && u.nodename[0] ? u.nodename : "unknown";
}

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  const std::size_t size = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {text, size};
}

std::string librariesText(const BuildInfo& build) {
  std::string text;
  for (const auto& [library, version] : build.libraries) text += (text.empty() ? "" : "; ") + library + ' ' + version;
  return text;
}

std::vector<std::pair<std::string, std::string>> librariesFrom(const std::string& text) {
  std::vector<std::pair<std::string, std::string>> libraries;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find("; ", begin), text.size());
    const std::size_t space = text.rfind(' ', end - 1);
    libraries.emplace_back(text.substr(begin, space - begin), text.substr(space + 1, end - space - 1));
    begin = end + 2;
  }
  return libraries;
}

std::string buildId(const BuildInfo& build) {
  Hasher hasher;
  hasher.field("sources").add(build.sources);
  hasher.field("compiler").add(build.compiler);
  hasher.field("flags").add(build.flags);
  hasher.field("target").add(build.target);
  hasher.field("libraries");
  for (const auto& [library, version] : build.libraries) hasher.add(library).add(version);
  return hasher.digest().text();
}

}  // namespace morula
