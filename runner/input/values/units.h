#pragma once
// Units in which people see lengths and times: in pictures, charts, pages and sentences. Results are computed, stored,
// exported and given to programs in the scene's own units.
#include <string>
#include <string_view>

namespace morula {

struct Units {
  std::string length, time;           // "µm", "min"; "": the scene's own
  double perLength = 1, perTime = 1;  // how many of the unit are one length, one time of the scene; > 0

  bool any() const { return !length.empty() || !time.empty(); }
  bool operator==(const Units&) const = default;
};

/// A unit for people: numbers in a unit of the scene, times `factor`, are in `name`.
struct ShownUnit {
  double factor = 1;
  std::string name;  // "µm³"; "": a pure number

  /// Returns "volume [µm³]".
  std::string after(const std::string& title) const { return name.empty() ? title : title + " [" + name + "]"; }
};

/// Converts the unit of a measure: products and quotients of lengths and times, with ² and ³. A unit with any other
/// part, such as a force, or with a part that has no name stays as it is.
ShownUnit shownUnit(const Units& units, std::string_view unit);

/// Returns the units that all runs have, where `of` gives those of each run; the scenes' own units if runs differ.
template <class Runs, class Of>
Units unitsOfAll(const Runs& runs, Of of) {
  for (const auto& run : runs)
    if (of(run) != of(runs.front())) return {};
  return runs.empty() ? Units{} : of(runs.front());
}

/// Returns the title of an axis: "time [min]", or "time" in the scene's own unit.
std::string timeLabel(const Units& units);

/// Returns "48 min", or "12" in the scene's own time, with `digits` significant digits.
std::string shownTime(const Units& units, double time, int digits = 4);

}  // namespace morula
