#include "tracks/wording.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "files/printable.h"
#include "files/text.h"

namespace morula::tracks {

std::string inQuotes(std::string_view text) { return "'" + std::string(text) + "'"; }

bool precedes(std::string_view a, std::string_view b) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  const auto digits = [&](std::string_view text) {
    return static_cast<std::size_t>(std::ranges::find_if_not(text, isDigit) - text.begin());
  };
  while (!a.empty() && !b.empty()) {
    const std::size_t m = digits(a), n = digits(b);
    if (m > 0 && n > 0 && m != n) return m < n;
    if (a[0] != b[0]) return a[0] < b[0];
    a.remove_prefix(1), b.remove_prefix(1);
  }
  return a.size() < b.size();
}

void assume(std::vector<std::string>& sentences, const std::string& what, const std::vector<std::string>& cells) {
  constexpr std::size_t shown = 3;
  if (cells.empty()) return;
  std::vector<std::string> first(cells.begin(), cells.begin() + static_cast<long>(std::min(cells.size(), shown)));
  const std::string rest = cells.size() > shown ? " and " + std::to_string(cells.size() - shown) + " more" : "";
  sentences.push_back(what + ": " + join(first) + rest);
}

std::string word(const std::string& text) {
  const bool isPlain = isMadeOf(text, "_") && isMadeOf(text.substr(0, 1), "") && text[0] >= 'A';
  std::string small = text;
  for (char& c : small) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  for (const char* taken : {"y", "n", "yes", "no", "on", "off", "true", "false", "null"})
    if (small == taken) return yamlText(text);
  return isPlain ? text : yamlText(text);
}

std::string rounded(double a, int decimals) {
  const double scale = std::pow(10, decimals), value = std::round(a * scale) / scale;
  return numberText(value == 0 ? 0 : value, 12);
}

std::string triple(const Vector& v) { return "[" + rounded(v.x) + ", " + rounded(v.y) + ", " + rounded(v.z) + "]"; }

namespace {
constexpr std::size_t width = 110;  // of a line
}  // namespace

std::string flow(const std::vector<std::string>& entries, char open, char close) {
  std::string text(1, open), line = join(entries);
  if (line.size() < width - 20) return text + line + close;
  line = "\n   ";
  for (const std::string& entry : entries) {
    if (line.size() + entry.size() > width) text += line, line = "\n   ";
    line += " " + entry + (&entry == &entries.back() ? "" : ",");
  }
  return text + line + "\n  " + close;
}

std::string comment(const std::string& text) {
  std::string lines, line = "#";
  for (const std::string& w : wordsOf(printableLine(text))) {
    if (line.size() + w.size() > width) lines += line + "\n", line = "#";
    line += " " + w;
  }
  return lines + line + "\n";
}

}  // namespace morula::tracks
