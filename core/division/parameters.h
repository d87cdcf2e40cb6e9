#pragma once
// What a scenario may say about where cells divide [Nilsson 2008, §4.4.2].
#include <cstdint>
#include <memory>
#include <span>

#include "base/vec3.h"

namespace morula {

class DivisionPolicy;

enum class DivisionPlane {  // its number is part of what a scenario means: new ones stand behind the others
  longest,                  // the default
  axis,
  random,  // the thesis' reference
  alternating,
};

struct DivisionParameters {
  DivisionPlane plane = DivisionPlane::longest;
  Vector axis{1, 0, 0};  // of planes that take one; any length but 0
};

/// A way to choose where cells divide. To add one: its value above, and its row and its class in policy.cpp.
struct DivisionPlaneKind {
  DivisionPlane plane;
  const char* name;         // as scenarios spell it; {name: [x, y, z]} if it takes an axis
  const char* meaning;      // "Cells divide across …"
  bool takesAxis = false;   // DivisionParameters::axis
  bool needsShape = false;  // looks for the direction in which a cell is longest: a sphere has none
  bool usesSeed = false;    // draws random numbers
  std::unique_ptr<DivisionPolicy> (*make)(const DivisionParameters&, std::uint64_t seed);
};

/// All of them, in the order in which people should meet them.
std::span<const DivisionPlaneKind> divisionPlanes();
const DivisionPlaneKind& kindOf(DivisionPlane plane);

}  // namespace morula
