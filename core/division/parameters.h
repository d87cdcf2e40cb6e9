#pragma once
// What a scenario may say about where cells divide [Nilsson 2008, §4.4.2].
#include "base/vec3.h"

namespace morula {

enum class DivisionPlane {
  longest,  // across the direction of largest extent (first principal axis); the default
  axis,     // across one fixed axis
  random,   // across a random direction, the thesis' reference
};

struct DivisionParameters {
  DivisionPlane plane = DivisionPlane::longest;
  Vector axis{1, 0, 0};  // for DivisionPlane::axis; any length but 0
};

}  // namespace morula
