#pragma once
// XXH3-128 over named fields, never over raw structs: padding, pointers and byte order cannot leak in.
#include <charconv>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace morula {

struct Hash {
  std::uint64_t high = 0, low = 0;
  /// 32 hexadecimal digits.
  std::string text() const;
  friend constexpr auto operator<=>(const Hash&, const Hash&) = default;
};

/// Collects fields and digests them. Two hashers fed the same fields in the same order agree on every machine.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;

  /// Opens a field: its name goes into the hash, so that swapped or missing fields show.
  Hasher& field(std::string_view name);
  Hasher& add(std::uint64_t v);
  Hasher& add(std::int64_t v) { return add(static_cast<std::uint64_t>(v)); }
  Hasher& add(int v) { return add(static_cast<std::int64_t>(v)); }
  Hasher& add(bool v) { return add(std::uint64_t{v}); }
  /// Adds the bits of the number, so −0.0 and 0.0 differ. NaN throws BugError: a failed run has no hash.
  Hasher& add(double v);
  Hasher& add(std::string_view text);
  Hasher& add(const char* text) { return add(std::string_view(text)); }
  Hasher& add(const Hash& h) { return add(h.high).add(h.low); }
  Hasher& add(std::span<const double> values);
  /// Adds bytes without their length, which texts have before them. The pieces of a file, in order, give the file's
  /// XXH3-128.
  Hasher& addPiece(std::string_view bytes);

  Hash digest() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns XXH3-128 of the bytes alone.
Hash hashOf(std::string_view bytes);

/// Reads 32 hexadecimal digits as Hash::text writes them; absent for anything else.
inline std::optional<Hash> readHash(std::string_view text) {
  if (text.size() != 32 || text.find_first_not_of("0123456789abcdef") != text.npos) return std::nullopt;
  Hash hash;
  std::from_chars(text.data(), text.data() + 16, hash.high, 16);
  std::from_chars(text.data() + 16, text.data() + 32, hash.low, 16);
  return hash;
}

}  // namespace morula
