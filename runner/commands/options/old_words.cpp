#include "options/old_words.h"

#include <algorithm>

#include "system/usage_error.h"

namespace morula::cli {
namespace {

struct OldWord {
  std::string verb, option;  // option: "" if the verb itself was renamed
  std::string now;           // the command that does the same now
};

const std::vector<OldWord>& oldWords() {
  static const std::vector<OldWord> all{
      {"accuracy", "--into-golden", "morula review SCENARIO --into-golden"},
      {"accuracy", "--stated", "morula review GOLDEN --stated"},
      {"trail", "", "morula internal trail"},
      {"describe", "", "morula internal describe"},
      {"engine-worker", "", "morula internal engine-worker"},
  };
  return all;
}

}  // namespace

void checkOldWords(const std::vector<std::string>& words) {
  if (words.empty()) return;
  const auto end = std::ranges::find(words, "--");  // the words behind it are files
  for (const OldWord& old : oldWords())
    if (words[0] == old.verb && (old.option.empty() || std::find(words.begin(), end, old.option) != end))
      throw UsageError(old.verb + (old.option.empty() ? "" : " " + old.option) + " is now: " + old.now);
}

}  // namespace morula::cli
