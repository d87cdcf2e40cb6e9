#pragma once
// Functions made of + − × ÷ and square roots only, because the library's others differ between machines in
// the last bit.
#include <bit>
#include <cstdint>

namespace morula {

/// Cube root of a positive, normal number, to within 1 ulp and the same bits everywhere: a guess from the
/// exponent, right to 4 %, and Newton's iteration for x³ = a, which doubles the correct digits in each iteration:
/// four suffice, and one more is a margin. Written with a/x², not x³ − a, for the cube of a guess that
/// is too large may overflow.
inline double cubeRoot(double a) {
  const auto bits = std::bit_cast<std::uint64_t>(a);
  double x = std::bit_cast<double>(bits / 3 + 0x2A9F7893782DA1CEu);
  for (int turn = 0; turn < 5; ++turn) x = x - (x - a / (x * x)) / 3;
  return x;
}

/// The largest power of two that does not exceed a positive, normal number.
inline double powerOfTwoBelow(double a) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a) & 0x7FF0000000000000u);
}

}  // namespace morula
