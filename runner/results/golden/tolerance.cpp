#include "golden/tolerance.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "golden/read_number.h"

namespace morula {
namespace {

constexpr const char* ruleForm =
    "`tolerance PATTERN exact|abs X|rel X [scale X]|ulp N [until_step N] why \"…\"` is expected";

/// Returns the words of a line; a quoted text is one word, without its quotes.
std::vector<std::string> fieldsOf(std::string_view line, const std::string& place) {
  std::vector<std::string> words;
  while (!line.empty()) {
    const bool quoted = line.front() == '"';
    const std::size_t end = quoted ? line.find('"', 1) : line.find(' ');
    if (quoted && end == std::string_view::npos)
      throw InputError(place + ": the quotation mark is not closed; close it");
    words.emplace_back(quoted ? line.substr(1, end - 1) : line.substr(0, end));
    line = end == std::string_view::npos ? std::string_view() : line.substr(end + (quoted ? 1 : 0));
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  }
  return words;
}

}  // namespace

std::string Tolerance::text() const {
  switch (kind) {
    case Kind::exact: return "exact";
    case Kind::absolute: return "abs " + exactText(amount);
    case Kind::relative: return "rel " + exactText(amount) + (scale > 0 ? " scale " + exactText(scale) : "");
    case Kind::ulp: return "ulp " + exactText(amount);
  }
  throw BugError("an invalid tolerance");
}

double Tolerance::size() const { return kind == Kind::ulp ? amount * std::numeric_limits<double>::epsilon() : amount; }

double Tolerance::allowed(double expected) const {
  const double size = std::abs(expected);
  if (kind == Kind::relative) return amount * std::max(size, scale);
  if (kind == Kind::ulp) return amount * (std::nextafter(size, INFINITY) - size);
  return kind == Kind::absolute ? amount : 0;
}

double Tolerance::share(double expected, double actual) const {
  constexpr double nothingAllowed = std::numeric_limits<double>::infinity();
  if (std::isnan(expected) || std::isnan(actual)) return nothingAllowed;
  if (std::bit_cast<std::uint64_t>(expected) == std::bit_cast<std::uint64_t>(actual)) return 0;
  if (kind == Kind::exact) return nothingAllowed;
  const bool inUlps = kind == Kind::ulp;
  const double used = inUlps ? static_cast<double>(ulpsBetween(expected, actual)) : std::abs(actual - expected);
  if (used == 0) return 0;  // −0 and 0
  const double most = inUlps ? amount : allowed(expected);
  return most > 0 && std::isfinite(used) ? used / most : nothingAllowed;
}

bool ToleranceRule::matches(std::string_view name, std::uint64_t step) const {
  return (!untilStep || step <= *untilStep) && fitsGlob(pattern, name);
}

std::string ToleranceRule::text() const {
  std::string line = "tolerance " + pattern + ' ' + tolerance.text();
  if (untilStep) line += " until_step " + std::to_string(*untilStep);
  if (!why.empty()) line += " why \"" + why + '"';
  return line;
}

ToleranceRule readRule(std::string_view line, const std::string& place) {
  const std::vector<std::string> words = fieldsOf(line, place);
  std::size_t next = 1;
  const auto fail = [&](const std::string& what) { return InputError(place + ": " + what + "; " + ruleForm); };
  const auto word = [&](const char* what) {
    if (next >= words.size()) throw fail(std::string(what) + " is missing");
    return words[next++];
  };
  const auto positive = [&](const char* what) {
    const std::string text = word(what);
    const std::optional<double> value = readReal(text);
    if (!value || !(*value > 0) || !std::isfinite(*value))
      throw fail(std::string(what) + " '" + text + "' is not a number above 0");
    return *value;
  };

  ToleranceRule rule;
  rule.pattern = word("the pattern");
  const std::string kind = word("the kind of tolerance");
  if (kind == "abs") rule.tolerance = {Tolerance::Kind::absolute, positive("the tolerance")};
  else if (kind == "rel") rule.tolerance = {Tolerance::Kind::relative, positive("the tolerance")};
  else if (kind == "ulp") rule.tolerance = {Tolerance::Kind::ulp, positive("the number of ulps")};
  else if (kind != "exact") throw fail("'" + kind + "' is no kind of tolerance");

  while (next < words.size()) {
    const std::string option = words[next++];
    if (option == "scale" && kind == "rel") {
      rule.tolerance.scale = positive("the scale");
    } else if (option == "until_step") {
      const std::string text = word("the step");
      rule.untilStep = readNatural(text);
      if (!rule.untilStep) throw fail("until_step '" + text + "' is not a whole number");
    } else if (option == "why") {
      rule.why = word("the reason");
    } else {
      throw fail("'" + option + "' is not understood here");
    }
  }
  if (kind == "ulp" && rule.tolerance.amount != std::floor(rule.tolerance.amount)) throw fail("ulps are whole numbers");
  if (kind != "exact" && rule.why.find_first_not_of(' ') == std::string::npos)
    throw InputError(place + ": a tolerance looser than exact needs its reason; add why \"…\"");
  return rule;
}

std::uint64_t ulpsBetween(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<std::uint64_t>::max();
  // Maps the bits to whole numbers in the order of the reals: negative numbers count down from zero.
  const auto place = [](double x) {
    const auto bits = std::bit_cast<std::int64_t>(x);
    return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
  };
  const std::int64_t pa = place(a), pb = place(b);
  return pa > pb ? static_cast<std::uint64_t>(pa) - static_cast<std::uint64_t>(pb)
                 : static_cast<std::uint64_t>(pb) - static_cast<std::uint64_t>(pa);
}

bool fitsGlob(std::string_view pattern, std::string_view name) {
  // Greedy, with one place to return to: on a mismatch the last * takes one more character.
  std::size_t p = 0, n = 0, star = std::string_view::npos, resume = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++, resume = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p, ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1, n = ++resume;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace morula
