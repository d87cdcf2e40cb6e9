#include "system/process_pipe.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace morula {

FileError processError(const std::string& what) {
  return FileError("a process of its own: " + what + ": " + std::strerror(errno));
}

std::string readToEnd(int from) {
  std::string text;
  std::array<char, 65536> buffer;
  while (true) {
    const ssize_t n = ::read(from, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
}

}  // namespace morula
