#include "system/process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace morula {

FileError processError(const std::string& what) {
  return FileError("a process of its own: " + what + ": " + std::strerror(errno));
}

Pipe makePipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw processError("no pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

std::string readToEnd(const Descriptor& from) {
  std::string text;
  std::array<char, 65536> buffer;
  while (true) {
    const ssize_t n = ::read(from.number(), buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
}

void setLimit(decltype(RLIMIT_CPU) what, rlim_t most) {
  rlimit limit{};
  ::getrlimit(what, &limit);
  limit.rlim_cur = std::min(limit.rlim_max, most);
  ::setrlimit(what, &limit);
}

ProcessEnd waitFor(pid_t process) {
  ProcessEnd end;
  rusage used{};
  while (::wait4(process, &end.status, 0, &used) < 0)
    if (errno != EINTR) throw processError("cannot be waited for");
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  end.cpuSeconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  end.maxMemory = static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
  return end;
}

}  // namespace morula
