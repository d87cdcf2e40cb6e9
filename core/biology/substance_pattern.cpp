#include "biology/substance_pattern.h"

#include <algorithm>

#include "biology/substances.h"

namespace morula {
namespace {

bool begins(std::string_view pattern, std::string_view text) {
  return text.starts_with(pattern.substr(0, pattern.size() - 1));
}

}  // namespace

bool fits(std::string_view pattern, std::string_view substance) {
  if (!pattern.ends_with('*')) return pattern == substance;
  return begins(pattern, substance) && (pattern == "*" || !substance::isReserved(substance));
}

bool fitsAny(std::string_view pattern, std::string_view substances) {
  while (!substances.empty()) {
    const std::size_t end = std::min(substances.find(' '), substances.size());
    if (fits(pattern, substances.substr(0, end))) return true;
    substances.remove_prefix(std::min(end + 1, substances.size()));
  }
  return false;
}

bool includes(std::string_view wide, std::string_view narrow) {
  // A beginning stands for itself, too: "AB*" for AB.
  return narrow.ends_with('*') ? wide.ends_with('*') && begins(wide, narrow.substr(0, narrow.size() - 1))
                               : fits(wide, narrow);
}

}  // namespace morula
