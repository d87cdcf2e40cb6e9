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

/// Returns the problem of a file of this type; "" for a regular file.
std::string typeProblem(const struct stat& status) {
  if (S_ISREG(status.st_mode)) return "";
  return "is " + std::string(typeName(status.st_mode)) + "; needs a file";
}

/// Opens a regular file without waiting. Its type is examined before, since opening a device may do something, and
/// again afterwards, since the name may mean another file by then.
Descriptor openRegular(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) refuseUnreadable(file);
  if (const auto problem = typeProblem(status); !problem.empty()) refuse(file, problem);
  Descriptor opened(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (!opened.isOpen() || ::fstat(opened.number(), &status) != 0) refuseUnreadable(file);
  if (const auto problem = typeProblem(status); !problem.empty()) refuse(file, problem);
  return opened;
}

/// Gives up to `count` bytes to `take`, in pieces. The announced size is ignored: files of /proc announce 0, and others
/// may grow meanwhile.
void readUpTo(const Descriptor& from, std::uint64_t count, const std::filesystem::path& file,
              const std::function<void(std::string_view)>& take) {
  char piece[1 << 16];
  while (count > 0) {
    const ssize_t n = ::read(from.number(), piece, std::min<std::uint64_t>(count, sizeof piece));
    if (n < 0 && errno != EINTR) refuseUnreadable(file);
    if (n == 0) break;
    if (n < 0) continue;
    take({piece, static_cast<std::size_t>(n)});
    count -= static_cast<std::uint64_t>(n);
  }
}

std::string readUpTo(const Descriptor& from, std::uint64_t count, const std::filesystem::path& file) {
  std::string bytes;
  readUpTo(from, count, file, [&](std::string_view piece) { bytes += piece; });
  return bytes;
}

}  // namespace

std::string readFile(const std::filesystem::path& file, std::uint64_t maxBytes) {
  const Descriptor opened = openRegular(file);
  std::string bytes = readUpTo(opened, maxBytes + 1, file);
  if (bytes.size() > maxBytes)
    refuse(file, "holds more than " + std::to_string(maxBytes >> 20) + " MiB, the most that is read of such a file");
  return bytes;
}

void readPieces(const std::filesystem::path& file, const std::function<void(std::string_view)>& take) {
  readUpTo(openRegular(file), UINT64_MAX, file, take);
}

std::string readBeginning(const std::filesystem::path& file, std::size_t count) {
  return readUpTo(openRegular(file), count, file);
}

std::string readHead(const std::filesystem::path& file, std::size_t count) {
  struct stat status {};
  return ::stat(file.c_str(), &status) != 0 || !typeProblem(status).empty() ? "" : readBeginning(file, count);
}

void requireRegularFile(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return;  // opening the file will tell the reason
  if (const auto problem = typeProblem(status); !problem.empty()) refuse(file, problem);
}

}  // namespace morula
