#pragma once
// The damping of springs and of contacts: a constant, or a share of critical damping.
//
//   c = 2 ζ √(k m)      ζ = 1: a mass m on a spring k returns to rest without an oscillation
//
// A constant is the thesis' way. Its limit of the time step falls with a vertex' mass m, where that of stiffness falls
// with √m: with many small cells it is damping that makes steps short. A share ζ keeps both limits in proportion.
#include <cmath>

#include "base/members.h"

namespace morula {

struct Damping {
  double constant = 0.02;  // [force·time/length] without effect where there is a ratio
  double ratio = 0;        // ζ [1]; 0: the constant counts

  Damping() = default;
  Damping(double constantOnly) : constant(constantOnly) {}  // NOLINT: a number is a constant

  friend bool operator==(const Damping&, const Damping&) = default;
  bool acts() const { return constant > 0 || ratio > 0; }
  /// Returns c [force·time/length] for a stiffness k [force/length] and a mass m of the moment.
  double of(double stiffness, double mass) const { return fixed() + perRoot(stiffness) * std::sqrt(mass); }
  double fixed() const { return ratio > 0 ? 0 : constant; }
  /// Returns 2 ζ √k, which √m times makes c.
  double perRoot(double stiffness) const { return 2 * ratio * std::sqrt(stiffness); }
};
MORULA_MEMBERS(Damping, constant, ratio)

}  // namespace morula
