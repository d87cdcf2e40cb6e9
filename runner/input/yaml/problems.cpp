#include "yaml/problems.h"

#include <algorithm>
#include <charconv>
#include <tuple>

#include "base/error.h"
#include "files/printable.h"

namespace morula::scenario {
namespace {

/// Returns true if the option already names the path: "--set stop.cycles" and "stop.cycles", "--seed" and "seed".
bool saysPath(std::string_view option, std::string_view path) {
  return option.ends_with(path) && option.size() > path.size() &&
         (option[option.size() - path.size() - 1] == ' ' || option[option.size() - path.size() - 1] == '-');
}

/// Removes ":<number>" from the front of the text and returns the number; 0 if there is none.
int takeNumber(std::string_view& text) {
  int value = 0;
  if (text.empty() || text[0] != ':') return 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value);
  if (error != std::errc()) return 0;
  text.remove_prefix(end - text.data());
  return value;
}

}  // namespace

std::string placeText(const std::string& file, const Place& place) {
  if (!place.option.empty()) return place.option;
  return file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
}

Problems::Problems(const std::string& file) : file_(printableLine(file)) {}

void Problems::add(const Place& place, std::string_view path, std::string what, std::string right) {
  std::string text = placeText(file_, place);
  text += ": ";
  if (!path.empty() && !saysPath(place.option, path)) text += std::string(path) + ": ";
  text += what;
  if (!right.empty()) text += "; " + right;
  lines_.push_back({!place.option.empty(), place.line, place.column, printableLine(text)});
}

void Problems::addForeign(const Place& fallback, std::string_view text) {
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    const auto line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty()) continue;
    Line entry{!fallback.option.empty(), fallback.line, fallback.column, printableLine(line)};
    if (line.starts_with(file_)) {
      auto rest = line.substr(file_.size());
      if (const int number = takeNumber(rest)) {
        entry.line = number;
        entry.column = takeNumber(rest);
      }
    }
    lines_.push_back(std::move(entry));
  }
}

void Problems::throwIfAny() const {
  if (lines_.empty()) return;
  auto sorted = lines_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Line& a, const Line& b) {
    return std::tie(a.fromOption, a.line, a.column) < std::tie(b.fromOption, b.line, b.column);
  });
  std::string text;
  constexpr std::size_t most = 100;  // more are counted, not listed
  for (std::size_t i = 0; i < std::min(most, sorted.size()); ++i) text += (i ? "\n" : "") + sorted[i].text;
  if (sorted.size() > most) text += "\n" + file_ + ": and " + std::to_string(sorted.size() - most) + " more mistakes";
  throw InputError(text);
}

}  // namespace morula::scenario
