#include "base/random.h"

#include <Random123/philox.h>

#include "base/hash.h"
#include "base/maths.h"

namespace morula {

std::array<std::uint32_t, 4> randomWords(const Draw& draw, std::uint32_t number) {
  // A path has up to 120 letters and the counter 128 bits, so the path is digested into the key with the seed.
  Hasher h;
  h.field("draw").add(draw.seed).add(draw.cell.high()).add(draw.cell.low()).add(draw.cell.depth());
  const Hash key = h.digest();
  r123::Philox4x32 philox;
  const r123::Philox4x32::ctr_type counter = {
      {number, draw.cycle, static_cast<std::uint32_t>(draw.purpose), static_cast<std::uint32_t>(key.high)}};
  const r123::Philox4x32::key_type k = {
      {static_cast<std::uint32_t>(key.low), static_cast<std::uint32_t>(key.low >> 32)}};
  const auto out = philox(counter, k);
  return {out[0], out[1], out[2], out[3]};
}

namespace {

/// Returns a number in [0, 1) from the first 53 of 64 bits.
double unitOf(std::uint32_t high, std::uint32_t low) {
  return static_cast<double>((std::uint64_t{high} << 32 | low) >> 11) * 0x1p-53;
}

}  // namespace

double randomUnit(const Draw& draw, std::uint32_t number) {
  const auto w = randomWords(draw, number);
  return unitOf(w[0], w[1]);
}

Vector randomDirection(const Draw& draw) {
  for (std::uint32_t i = 0;; i += 2) {
    const double u = 2 * randomUnit(draw, i) - 1, v = 2 * randomUnit(draw, i + 1) - 1;
    const double s = u * u + v * v;
    if (s >= 1) continue;
    const double root = 2 * std::sqrt(1 - s);
    return {u * root, v * root, 1 - 2 * s};
  }
}

double randomNormal(const Draw& draw, std::uint32_t number) {
  for (std::uint32_t attempt = 0;; ++attempt) {
    const auto w = randomWords(draw, number << 8 | (attempt & 0xFF));  // 256 failures in a row do not happen
    const double u = 2 * unitOf(w[0], w[1]) - 1, v = 2 * unitOf(w[2], w[3]) - 1;
    const double s = u * u + v * v;
    if (!(s > 0 && s < 1)) continue;
    const double deviate = u * std::sqrt(-2 * naturalLog(s) / s);
    if (deviate >= -largestNormal && deviate <= largestNormal) return deviate;
  }
}

double randomDeviate(const Draw& draw, std::uint32_t number) {
  return randomNormal(draw, number) / deviationOfNormal;
}

}  // namespace morula
