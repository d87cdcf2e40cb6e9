#pragma once
// Numbers of a comparison as words.
#include <fmt/format.h>

#include <optional>
#include <string>

#include "base/number_text.h"
#include "statistics/bootstrap.h"

namespace morula {

/// "p = 0.012", "p < 1e-15" where digits would be rounding; "" if there is none.
inline std::string pText(const std::optional<double>& p) {
  if (!p) return "";
  return *p < 1e-15 ? "p < 1e-15" : "p = " + numberText(*p, 2);
}

/// "0.42 to 0.44"; "-" if there is none.
inline std::string intervalText(const std::optional<Interval>& i) {
  return i ? numberText(i->low, 4) + " to " + numberText(i->high, 4) : "-";
}

inline std::string orDash(const std::optional<double>& a, int digits = 3) {
  return a ? numberText(*a, digits) : "-";
}

}  // namespace morula
