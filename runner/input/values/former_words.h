#pragma once
// Words that scenarios had in earlier versions. Each is refused, and the word that is in its place told.
#include <string_view>

namespace morula::scenario {

struct FormerWord {
  std::string_view path, value;  // of the parameter or section then; value: of the word that it took, "" for a key
  std::string_view now;          // the key or word in its place
  std::string_view reason;       // a sentence's second half: why it was replaced
  std::string_view remedy;
};

/// Returns null if no version had this key.
const FormerWord* formerKey(std::string_view path);

/// Returns null if this key took no such word in any version.
const FormerWord* formerValue(std::string_view path, std::string_view value);

}  // namespace morula::scenario
