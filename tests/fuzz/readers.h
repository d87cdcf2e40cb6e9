#pragma once
// Everything that reads what others wrote, as functions of bytes: whatever the bytes are, a reader takes them or
// refuses them with an error for people. Anything else (a BugError, another exception, a crash, a read out of bounds)
// is a finding.
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace morula::fuzz {

struct Reader {
  const char* name;
  /// Reads; throws only what is told to a user as a mistake of the input.
  void (*read)(std::string_view bytes);
  /// Valid inputs to begin with, from the repository's own files.
  std::vector<std::string> (*seeds)();
  int times = 1;  // as many inputs as are asked for
};

std::span<const Reader> readers();
/// Null if there is none of this name.
const Reader* readerNamed(std::string_view name);

/// True if the input was taken, false if it was refused as it should be. Throws what is a finding.
bool takes(const Reader& reader, std::string_view bytes);

}  // namespace morula::fuzz
