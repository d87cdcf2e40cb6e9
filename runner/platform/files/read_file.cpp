#include "files/read_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/error.h"
#include "files/descriptor.h"

namespace morula {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw FileError("'" + file.string() + "' " + why);
}

[[noreturn]] void refuseUnreadable(const std::filesystem::path& file) {
  refuse(file, std::string("cannot be read: ") + std::strerror(errno));
}

/// What is wrong with a file of this type; "" if it is a regular one.
std::string typeProblem(const struct stat& status) {
  if (S_ISREG(status.st_mode)) return "";
  return "is " + std::string(typeName(status.st_mode)) + "; needs a file";
}

/// Opened without waiting. Its type is looked at before, because opening a device may do something, and again afterwards,
/// because the name may have come to mean another file in between.
Descriptor openRegular(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) refuseUnreadable(file);
  if (const auto problem = typeProblem(status); !problem.empty()) refuse(file, problem);
  Descriptor opened(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (!opened.isOpen() || ::fstat(opened.number(), &status) != 0) refuseUnreadable(file);
  if (const auto problem = typeProblem(status); !problem.empty()) refuse(file, problem);
  return opened;
}

/// Reads up to `count` bytes.
std::string readUpTo(const Descriptor& from, std::uint64_t count, const std::filesystem::path& file) {
  std::string bytes;
  while (bytes.size() < count) {
    const std::size_t before = bytes.size();
    const std::size_t chunk = static_cast<std::size_t>(std::min<std::uint64_t>(count - before, 1 << 20));
    bytes.resize(before + chunk);
    const ssize_t n = ::read(from.number(), bytes.data() + before, chunk);
    if (n < 0 && errno != EINTR) refuseUnreadable(file);
    bytes.resize(before + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    if (n == 0) break;
  }
  return bytes;
}

}  // namespace

std::string readFile(const std::filesystem::path& file, std::uint64_t maxBytes) {
  const Descriptor opened = openRegular(file);
  // Not by its announced size: files of /proc announce 0, and others may grow meanwhile.
  std::string bytes = readUpTo(opened, maxBytes + 1, file);
  if (bytes.size() > maxBytes)
    refuse(file, "holds more than " + std::to_string(maxBytes >> 20) + " MiB, the most that is read of such a file");
  return bytes;
}

std::string readBeginning(const std::filesystem::path& file, std::size_t count) {
  return readUpTo(openRegular(file), count, file);
}

std::string readHead(const std::filesystem::path& file, std::size_t count) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0 || !typeProblem(status).empty()) return "";
  return readBeginning(file, count);
}

void requireRegularFile(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return;  // opening it will say why
  if (const auto problem = typeProblem(status); !problem.empty()) refuse(file, problem);
}

}  // namespace morula
