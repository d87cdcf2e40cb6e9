#include "base/did_you_mean.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace morula {
namespace {
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string digitsOf(std::string_view word) {
  std::string digits;
  std::ranges::copy_if(word, std::back_inserter(digits), [](char c) { return c >= '0' && c <= '9'; });
  return digits;
}
}  // namespace

int editDistance(std::string_view a, std::string_view b) {
  // Three rows of the classic table: the row before last serves the swaps.
  const int columns = static_cast<int>(b.size());
  std::vector<int> beforeLast(columns + 1), last(columns + 1), row(columns + 1);
  for (int j = 0; j <= columns; ++j) row[j] = j;
  for (int i = 1; i <= static_cast<int>(a.size()); ++i) {
    std::swap(beforeLast, last);
    std::swap(last, row);
    row[0] = i;
    for (int j = 1; j <= columns; ++j) {
      const int replaced = last[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], beforeLast[j - 2] + 1);
    }
  }
  return row[columns];
}

bool equalButForCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

std::string closest(std::string_view word, std::span<const std::string> candidates) {
  const int limit = static_cast<int>(word.size()) / 3;
  int best = limit + 1;
  std::string found;
  for (const std::string& candidate : candidates) {
    // Lengths alone may rule a candidate out, which keeps thousands of candidates cheap.
    const int lengthDifference = std::abs(static_cast<int>(candidate.size()) - static_cast<int>(word.size()));
    if (lengthDifference >= best) continue;
    const int distance = equalButForCase(word, candidate) ? 0 : editDistance(word, candidate);
    if (distance < best && digitsOf(word) == digitsOf(candidate)) {
      best = distance;
      found = candidate;
    }
  }
  return found;
}

}  // namespace morula
