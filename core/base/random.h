#pragma once
// Counter-based random numbers: Philox4x32-10 [Salmon et al. 2011]. No stream, no state: a draw is a function of
// (seed, cell, cycle, purpose, number), so the order of cells and threads cannot matter, and two policies that ask for
// the same draw get the same number.
#include <array>
#include <cstdint>

#include "base/cell_path.h"
#include "base/vec3.h"

namespace morula {

enum class Purpose : std::uint32_t {  // part of what a seed means: new ones stand behind the others
  divisionPlane = 1,
  perturbation = 2,
  test = 3,
  motility = 20,
};

struct Draw {
  std::uint64_t seed = 0;
  CellPath cell;
  std::uint32_t cycle = 0;
  Purpose purpose = Purpose::test;
};

/// Four 32-bit words for draw number `number`.
std::array<std::uint32_t, 4> randomWords(const Draw& draw, std::uint32_t number);

/// Uniform in [0, 1), 53 bits.
double randomUnit(const Draw& draw, std::uint32_t number);

/// Uniform on the unit sphere, by rejection [Marsaglia 1972]: only + − × and square roots.
Vector randomDirection(const Draw& draw);

}  // namespace morula
