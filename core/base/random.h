#pragma once
// Counter-based random numbers: Philox4x32-10 [Salmon et al. 2011]. No stream, no state: a draw is a function of
// (seed, cell, cycle, purpose, number), so the order of cells and threads cannot matter, and two policies that ask for
// the same draw get the same number.
#include <array>
#include <cstdint>

#include "base/cell_path.h"
#include "base/vec3.h"

namespace morula {

enum class Purpose : std::uint32_t {  // part of what a seed means: new purposes take new numbers
  divisionPlane = 1,
  perturbation = 2,
  test = 3,
  tilt = 4,
  cycleVariation = 5,
  shareVariation = 6,
  startVariation = 7,
  motility = 20,
  adhesionVariation = 21,
  experiment = 22,
  resampling = 40,  // of values, not of a scene: runner/studies/statistics
};

struct Draw {
  std::uint64_t seed = 0;
  CellPath cell;
  std::uint32_t cycle = 0;
  Purpose purpose = Purpose::test;
};

/// Returns four 32-bit words for draw number `number`.
std::array<std::uint32_t, 4> randomWords(const Draw& draw, std::uint32_t number);

/// Returns a number uniform in [0, 1), with 53 bits.
double randomUnit(const Draw& draw, std::uint32_t number);

/// Returns a direction uniform on the unit sphere, by rejection [Marsaglia 1972]: only + − × and square roots.
Vector randomDirection(const Draw& draw);

/// The largest distance of a normal deviate from 0.
constexpr double largestNormal = 3;
/// The standard deviation of normal deviates within ±3: √(1 − 6 φ(3)/(2 Φ(3) − 1)).
constexpr double deviationOfNormal = 0.9865783925581086;
/// The largest distance of randomDeviate from 0.
constexpr double largestDeviate = largestNormal / deviationOfNormal;

/// Returns a deviate of the normal distribution with mean 0 and standard deviation 1. A deviate beyond ±3 is drawn
/// anew, so that nothing strays without bound; the others have the standard deviation deviationOfNormal. Polar method
/// [Marsaglia & Bray 1964]: s = u² + v² in (0, 1), u √(−2 ln s / s). `number` below 2²⁴.
double randomNormal(const Draw& draw, std::uint32_t number = 0);

/// Returns randomNormal over its standard deviation: a bounded deviate of standard deviation 1, for variations whose
/// deviation a scene states. At most 3.041 from 0.
double randomDeviate(const Draw& draw, std::uint32_t number = 0);

}  // namespace morula
