#pragma once
// Functions of bytes for everything that reads files of others. Whatever the bytes are, a reader takes them or refuses
// them with an error for users. Any other outcome (a BugError, another exception, a crash, a read out of bounds) is a
// finding.
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace morula::fuzz {

struct Reader {
  const char* name;
  /// Reads; throws only errors that tell a user of wrong input.
  void (*read)(std::string_view bytes);
  /// Valid inputs to begin with, from the repository's own files.
  std::vector<std::string> (*seeds)();
  int times = 1;  // factor of the number of inputs
};

std::span<const Reader> readers();
/// Returns the reader of this name; null if there is none.
const Reader* readerNamed(std::string_view name);

/// Returns true if the input was taken, false if it was properly refused. Throws a finding.
bool takes(const Reader& reader, std::string_view bytes);

}  // namespace morula::fuzz
