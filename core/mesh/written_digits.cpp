#include <algorithm>
#include <charconv>
#include <cmath>

#include "mesh/validity.h"

namespace morula {
namespace {

/// 10ᵉ by repeated multiplication or division, which is the same on every machine.
double powerOfTen(int e) {
  double power = 1;
  for (; e > 0; --e) power *= 10;
  for (; e < 0; ++e) power /= 10;
  return power;
}

}  // namespace

void WrittenDigits::note(std::string_view number) {
  const std::size_t mantissa = std::min(number.find_first_of("eE"), number.size());
  int digits = 0, behindPoint = 0, exponent = 0;
  bool isBehind = false;
  for (const char c : number.substr(0, mantissa)) {
    if (c == '.') isBehind = true;
    if (c < '0' || c > '9') continue;
    if (isBehind) ++behindPoint;
    if (digits > 0 || c != '0') ++digits;
  }
  if (mantissa < number.size()) {
    std::string_view rest = number.substr(mantissa + 1);
    if (rest.starts_with('+')) rest.remove_prefix(1);
    std::from_chars(rest.data(), rest.data() + rest.size(), exponent);
  }
  decimals = std::max(decimals, std::clamp(behindPoint - exponent, 0, 400));
  significant = std::max(significant, digits);
}

double WrittenDigits::roundingOf(double coordinate) const {
  int before = 0;  // digits before the point; negative for zeros behind it
  const double size = std::abs(coordinate);
  if (size > 0) {
    for (double power = 1; size >= power; power *= 10) ++before;
    for (double power = 0.1; before <= 0 && size < power && before > -400; power /= 10) --before;
  }
  return 0.5 * std::max(powerOfTen(-decimals), size > 0 ? powerOfTen(before - significant) : 0);
}

}  // namespace morula
