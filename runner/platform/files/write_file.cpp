#include "files/write_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>

#include "base/error.h"
#include "files/descriptor.h"
#include "files/draft.h"
#include "files/folders.h"

namespace morula {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuseToWrite(const fs::path& file, const std::string& why) {
  throw FileError("'" + file.string() + "' cannot be written: " + why);
}

/// Returns the type of `file` itself, without following a link; nothing if it does not exist.
std::optional<mode_t> typeOf(const fs::path& file) {
  struct stat status {};
  if (::lstat(file.c_str(), &status) == 0) return status.st_mode;
  if (errno == ENOENT) return std::nullopt;
  refuseToWrite(file, std::strerror(errno));
}

/// Throws unless `mode` is of a regular file, and the file may be written.
void requireWritable(const fs::path& file, mode_t mode) {
  if (!S_ISREG(mode)) refuseToWrite(file, std::string("it is ") + typeName(mode) + "; give the name of a file");
  if (::access(file.c_str(), W_OK) != 0) refuseToWrite(file, std::strerror(errno));
}

/// Writes the bytes to a draft that replaces the file in one step.
void replace(const fs::path& file, std::string_view bytes) {
  Draft draft(file);
  draft.write(bytes);
  draft.takePlace();
}

}  // namespace

void writeFile(const fs::path& file, std::string_view bytes, Content kind) {
  if (const auto mode = typeOf(file)) {
    requireWritable(file, *mode);
    const Content there = contentOfFile(file);
    if (there != kind && there != Content::empty)
      refuseToWrite(file, std::string("the file exists already and is ") + name(there) + ", which " + name(kind) +
                              " would replace; give another name, or remove it first");
  }
  replace(file, bytes);
}

void requireNewFile(const fs::path& file) {
  if (typeOf(file)) refuseToWrite(file, std::string("the file exists already and is ") + name(contentOfFile(file)));
  if (file.has_parent_path() && !isFolder(file.parent_path())) refuseToWrite(file, std::strerror(ENOENT));
}

void writeNewFile(const fs::path& file, std::string_view bytes) {
  requireNewFile(file);
  replace(file, bytes);
}

void overwriteFile(const fs::path& file, std::string_view bytes) {
  if (const auto mode = typeOf(file)) requireWritable(file, *mode);
  replace(file, bytes);
}

void appendToFile(const fs::path& file, std::string_view bytes) {
  if (const auto mode = typeOf(file)) requireWritable(file, *mode);
  Descriptor out(::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666));
  if (!out.isOpen() || !writeAll(out.number(), bytes) || !out.close()) refuseToWrite(file, std::strerror(errno));
}

}  // namespace morula
