#pragma once
// What a scenario may say about where cells divide [Nilsson 2008, §4.4.2].
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/vec3.h"

namespace morula {

class DivisionPolicy;

enum class DivisionPlane {  // its number is part of what a scenario means: new ones stand behind the others
  longest,                  // the default
  axis,
  random,  // the thesis' reference
  alternating,
};

/// How one cell is cut: a plane, and what that plane takes.
struct PlaneChoice {
  DivisionPlane plane = DivisionPlane::longest;
  Vector axis{1, 0, 0};     // of planes that take one; any length but 0
  std::string substance{};  // of planes that take one: a name, or its beginning and '*'
  friend bool operator==(const PlaneChoice&, const PlaneChoice&) = default;
};

/// How some cells divide. What it does not say is as of a cell that no rule names.
struct DivisionRule {
  std::vector<std::string> of{};       // patterns: a cell that holds a substance for each of them
  std::optional<PlaneChoice> plane{};  // absent: DivisionParameters::otherwise
  std::optional<double> share{};       // [1] of the volume that daughter A is to have; absent: the plane goes
                                       // through the centre
  std::optional<double> tilt{};        // [degree] sd of the axis about its direction, by the seed
};

struct DivisionParameters {
  PlaneChoice otherwise{};            // of cells that no rule names
  std::vector<DivisionRule> rules{};  // the first that fits a cell counts
};

enum class Takes { nothing, axis, substance };

/// A way to choose where cells divide. To add one: its value above, and its row and its class in policy.cpp.
struct DivisionPlaneKind {
  DivisionPlane plane;
  const char* name;     // as scenarios spell it; {name: [x, y, z]} or {name: a0} if it takes something
  const char* meaning;  // "Cells divide across …"
  Takes takes = Takes::nothing;  // PlaneChoice::axis or ::substance
  bool needsShape = false;       // looks for the direction in which a cell is longest: a sphere has none
  bool usesSeed = false;         // draws random numbers
  std::unique_ptr<DivisionPolicy> (*make)(const PlaneChoice&, std::uint64_t seed);
};

/// All of them, in the order in which people should meet them.
std::span<const DivisionPlaneKind> divisionPlanes();
const DivisionPlaneKind& kindOf(DivisionPlane plane);

}  // namespace morula
