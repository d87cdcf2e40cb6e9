#include "base/hash.h"

#include <limits>
#include <set>
#include <vector>

#include "catch.h"

using namespace morula;

namespace {

// The bytes over which the authors of xxHash publish their check values: the top bytes of a multiplicative
// sequence.
std::vector<std::uint64_t> checkWords(std::size_t bytes) {
  std::vector<std::uint64_t> words(bytes / 8, 0);
  std::uint64_t state = 0x9E3779B1u;
  for (std::size_t i = 0; i < bytes; ++i, state *= 0x9E3779B185EBCA8Du) words[i / 8] |= (state >> 56) << 8 * (i % 8);
  return words;
}

template <class... Values>
Hash hashOf(const Values&... values) {
  Hasher h;
  (h.add(values), ...);
  return h.digest();
}

}  // namespace

TEST_CASE("Hashes are XXH3-128: the published check values") {
  struct {
    std::size_t bytes;
    Hash hash;
  } const known[] = {
      {0, {0x99AA06D3014798D8, 0x6001C324468D497F}},    {24, {0x0CE966E4678D3761, 0x1E7044D28B1B901D}},
      {48, {0xA002AC4E5478227E, 0xF942219AED80F67B}},   {512, {0x18D2D110DCC9BCA1, 0x617E49599013CB6B}},
      {2048, {0xF736557FD47073A5, 0xDD59E2C3A5F038E0}}, {2240, {0xCCB134FBFA7CE49D, 0x6E73A90539CF2948}},
  };
  for (const auto& [bytes, hash] : known) {
    CAPTURE(bytes);
    Hasher h;
    for (std::uint64_t word : checkWords(bytes)) h.add(word);
    CHECK(h.digest() == hash);
  }
  // "abcdefgh", first letter in the lowest byte.
  CHECK(hashOf(std::uint64_t{0x6867666564636261}) == Hash{0xDAC23237AF373533, 0x42B702B313880F12});
}

TEST_CASE("A number enters by its bits, a text by its length and letters") {
  CHECK(hashOf(1.0) == hashOf(std::uint64_t{0x3FF0000000000000}));
  CHECK(hashOf(-1) == hashOf(std::numeric_limits<std::uint64_t>::max()));
  CHECK(hashOf(std::int64_t{-1}) == hashOf(-1));
  CHECK(hashOf(true) == hashOf(1));
  CHECK(hashOf("abcdefgh") == hashOf(8, std::uint64_t{0x6867666564636261}));
  CHECK(Hasher().field("x").digest() == hashOf("x"));
  CHECK(hashOf(Hash{7, 9}) == hashOf(7, 9));
  const std::vector<double> three = {1, 2, 3};
  CHECK(hashOf(std::span<const double>(three)) == hashOf(1.0, 2.0, 3.0));
}

TEST_CASE("Every bit of a field counts") {
  std::set<Hash> seen;
  const double base = 0.1;
  seen.insert(hashOf(base));
  for (int bit = 0; bit < 64; ++bit) {
    const double other = std::bit_cast<double>(std::bit_cast<std::uint64_t>(base) ^ std::uint64_t{1} << bit);
    REQUIRE(seen.insert(hashOf(other)).second);
  }
}

TEST_CASE("Names, order, borders and zero's sign count") {
  const auto named = [](const char* a, double x, const char* b, double y) {
    return Hasher().field(a).add(x).field(b).add(y).digest();
  };
  const Hash base = named("x", 1, "y", 2);
  CHECK(base == named("x", 1, "y", 2));
  CHECK(base != named("y", 1, "x", 2));
  CHECK(base != named("x", 2, "y", 1));
  CHECK(base != named("x", 1, "z", 2));
  CHECK(base != Hasher().field("y").add(2.0).field("x").add(1.0).digest());
  CHECK(hashOf("ab", "c") != hashOf("a", "bc"));
  CHECK(hashOf("") != Hasher().digest());
  CHECK(hashOf(0.0) != hashOf(-0.0));
  CHECK(hashOf(0.0, 1.0) != hashOf(1.0, 0.0));
}

TEST_CASE("A number that is none is a bug, infinity is not") {
  for (double nan : {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::quiet_NaN(),
                     std::numeric_limits<double>::signaling_NaN()}) {
    CHECK_THROWS_AS(hashOf(nan), BugError);
    const std::vector<double> values = {1, nan};
    CHECK_THROWS_AS(hashOf(std::span<const double>(values)), BugError);
  }
  CHECK(hashOf(std::numeric_limits<double>::infinity()) != hashOf(-std::numeric_limits<double>::infinity()));
}

TEST_CASE("A digest may be taken on the way, and says nothing else of the rest") {
  Hasher h;
  h.add(1);
  const Hash first = h.digest();
  CHECK(first == h.digest());
  CHECK(first == hashOf(1));
  CHECK(h.add(2).digest() == hashOf(1, 2));
}

TEST_CASE("A hash is written as 32 digits, the high word first") {
  CHECK(Hash{}.text() == std::string(32, '0'));
  CHECK(Hash{0x0123456789ABCDEF, 0xFEDCBA9876543210}.text() == "0123456789abcdeffedcba9876543210");
  CHECK(Hasher().digest().text() == "99aa06d3014798d86001c324468d497f");
  CHECK(Hash{1, 0} > Hash{0, 2});
}
