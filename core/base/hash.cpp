#include "base/hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cmath>

#include "base/error.h"

namespace morula {

static_assert(std::endian::native == std::endian::little, "hashes are defined over little-endian bytes");

struct Hasher::State {
  XXH3_state_t xxh;
};

Hasher::Hasher() : state_(new State) { XXH3_128bits_reset(&state_->xxh); }
Hasher::~Hasher() = default;

Hasher& Hasher::field(std::string_view name) { return add(name); }

Hasher& Hasher::add(std::uint64_t v) {
  XXH3_128bits_update(&state_->xxh, &v, sizeof v);
  return *this;
}

Hasher& Hasher::add(double v) {
  MORULA_CHECK(!std::isnan(v), "a hash over a number that is not one");
  return add(std::bit_cast<std::uint64_t>(v));
}

Hasher& Hasher::add(std::string_view text) { return add(std::uint64_t{text.size()}).addPiece(text); }

Hasher& Hasher::addPiece(std::string_view bytes) {
  XXH3_128bits_update(&state_->xxh, bytes.data(), bytes.size());
  return *this;
}

Hasher& Hasher::add(std::span<const double> values) {
  bool numbers = true;
  for (double v : values) numbers &= !std::isnan(v);
  MORULA_CHECK(numbers, "a hash over a number that is not one");
  XXH3_128bits_update(&state_->xxh, values.data(), values.size_bytes());
  return *this;
}

Hash Hasher::digest() const {
  const XXH128_hash_t h = XXH3_128bits_digest(&state_->xxh);
  return {h.high64, h.low64};
}

Hash hashOf(std::string_view bytes) {
  const XXH128_hash_t h = XXH3_128bits(bytes.data(), bytes.size());
  return {h.high64, h.low64};
}

std::string Hash::text() const {
  static constexpr char digits[] = "0123456789abcdef";
  std::string s(32, '0');
  for (int i = 0; i < 32; ++i) s[i] = digits[((i < 16 ? high : low) >> (60 - 4 * (i % 16))) & 15];
  return s;
}

}  // namespace morula
