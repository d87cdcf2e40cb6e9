#pragma once
// e^(−x), made of + − × ÷ only, because the library's differs between machines in the last bit.
#include <bit>
#include <cstdint>

namespace morula {

/// e^(−x) for x ≥ 0, to within 1e-15 of its value; 0 from x = 700 on. With −x = n ln 2 + r, n whole and |r| ≤ ½ ln 2,
///
///   e^(−x) = 2^n e^r,   e^r = 1 + r (1 + r/2 (1 + r/3 (…)))
///
/// where seventeen terms leave out less than 1e-21. ln 2 in two parts: n times the first is exact.
inline double decay(double x) {
  constexpr double ln2 = 0.6931471805599453, high = 0x1.62e42fee00000p-1, low = 0x1.a39ef35793c76p-33;
  if (!(x < 700)) return 0;
  const int n = -static_cast<int>(x / ln2 + 0.5);
  const double r = (-x - n * high) - n * low;
  double series = 1;
  for (int k = 17; k >= 1; --k) series = 1 + r / k * series;
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + n) << 52) * series;
}

}  // namespace morula
