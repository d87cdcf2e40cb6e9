#pragma once
// In which units people see lengths and times: in pictures, charts, pages and sentences. What is computed, stored,
// exported and given to programs stays in the scene's own.
#include <string>
#include <string_view>

namespace morula {

struct Units {
  std::string length, time;           // "µm", "min"; "": the scene's own
  double perLength = 1, perTime = 1;  // so many of them are one length, one time of the scene; > 0

  bool any() const { return !length.empty() || !time.empty(); }
  bool operator==(const Units&) const = default;
};

/// How numbers in a unit of the scene are shown: times `factor`, in `name`.
struct ShownUnit {
  double factor = 1;
  std::string name;  // "µm³"; "": a pure number

  /// "volume [µm³]".
  std::string after(const std::string& title) const { return name.empty() ? title : title + " [" + name + "]"; }
};

/// Converts a unit as measures give it: products and quotients of lengths and times, with ² and ³. One with any other
/// part, as a force, or a part without a name stays what it is: nothing is said of masses.
ShownUnit shownUnit(const Units& units, std::string_view unit);

/// Returns the units that all runs have, where `of` gives those of each run; the scenes' own units if runs differ.
template <class Runs, class Of>
Units unitsOfAll(const Runs& runs, Of of) {
  for (const auto& run : runs)
    if (of(run) != of(runs.front())) return {};
  return runs.empty() ? Units{} : of(runs.front());
}

/// "time [min]", or "time" in the scene's own: for an axis.
std::string timeLabel(const Units& units);

/// "48 min", or "12" in the scene's own time; with so many significant digits.
std::string shownTime(const Units& units, double time, int digits = 4);

}  // namespace morula
