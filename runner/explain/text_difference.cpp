#include "explain/text_difference.h"

#include <algorithm>

#include "files/text.h"

namespace morula {

std::string differingLines(const std::string& theirs, const std::string& ours) {
  constexpr std::size_t most = 40, far = 50;  // lines shown; how far to look for where the two meet again
  const auto a = linesOf(theirs), b = linesOf(ours);
  std::vector<std::string> shown;
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j]) {
      ++i, ++j;
      continue;
    }
    // The nearest place behind at which both go on with the same line.
    std::size_t skipA = a.size() - i, skipB = b.size() - j;
    for (std::size_t sum = 1; sum < std::min(far, (a.size() - i) + (b.size() - j)); ++sum) {
      bool met = false;
      for (std::size_t k = 0; k <= sum && !met; ++k)
        if (i + k < a.size() && j + (sum - k) < b.size() && a[i + k] == b[j + (sum - k)])
          skipA = k, skipB = sum - k, met = true;
      if (met) break;
    }
    for (std::size_t k = 0; k < skipA; ++k) shown.push_back("  - " + a[i + k] + '\n');
    for (std::size_t k = 0; k < skipB; ++k) shown.push_back("  + " + b[j + k] + '\n');
    i += skipA, j += skipB;
  }
  std::string text;
  for (std::size_t k = 0; k < std::min(most, shown.size()); ++k) text += shown[k];
  if (shown.size() > most) text += "  and " + std::to_string(shown.size() - most) + " lines more\n";
  return text;
}

}  // namespace morula
