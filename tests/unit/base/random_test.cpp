#include "base/random.h"

#include <Random123/philox.h>

#include <algorithm>
#include <set>
#include <vector>

#include "base/hash.h"
#include "catch.h"

using namespace morula;

namespace {

using Words = std::array<std::uint32_t, 4>;

// Philox4x32 in ten rounds, written down from the paper [Salmon et al. 2011, section 3.3].
Words philox(Words x, std::uint32_t key0, std::uint32_t key1) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * x[0], b = std::uint64_t{0xCD9E8D57} * x[2];
    x = {static_cast<std::uint32_t>(b >> 32) ^ x[1] ^ key0, static_cast<std::uint32_t>(b),
         static_cast<std::uint32_t>(a >> 32) ^ x[3] ^ key1, static_cast<std::uint32_t>(a)};
    key0 += 0x9E3779B9;
    key1 += 0xBB67AE85;
  }
  return x;
}

// Number of draws, each of its own cell: enough for three digits of a mean.
constexpr int many = 100'000;

Draw drawOfCell(int i) {
  CellPath path;
  for (int bit = 0; bit < 17; ++bit) path = path.daughter(i >> bit & 1);
  return {42, path, 3, Purpose::test};
}

}  // namespace

TEST_CASE("The library is Philox4x32-10: the published known answers") {
  struct {
    Words counter;
    std::uint32_t key0, key1;
    Words answer;
  } const known[] = {
      {{0, 0, 0, 0}, 0, 0, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
      {{~0u, ~0u, ~0u, ~0u}, ~0u, ~0u, {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
      {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
       0xa4093822,
       0x299f31d0,
       {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
  };
  for (const auto& [c, key0, key1, answer] : known) {
    const auto out = r123::Philox4x32()({{c[0], c[1], c[2], c[3]}}, {{key0, key1}});
    CHECK(Words{out[0], out[1], out[2], out[3]} == answer);
    CHECK(philox(c, key0, key1) == answer);
  }
}

TEST_CASE("A draw is Philox of its number, cycle and purpose, keyed by the digest of seed and cell") {
  for (const char* path : {"", "A", "ABBA", "BBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBA"})
    for (std::uint64_t seed : {0ull, 1ull, 20080617ull, ~0ull}) {
      const Draw draw{seed, CellPath::parse(path), 5, Purpose::divisionPlane};
      const Hash key =
          Hasher().field("draw").add(seed).add(draw.cell.high()).add(draw.cell.low()).add(draw.cell.depth()).digest();
      CHECK(randomWords(draw, 7) == philox({7, 5, 1, static_cast<std::uint32_t>(key.high)},
                                           static_cast<std::uint32_t>(key.low),
                                           static_cast<std::uint32_t>(key.low >> 32)));
    }
}

TEST_CASE("The words of a draw never change: results of old runs rest on them") {
  const Draw draw{20080617, CellPath::parse("ABBA"), 3, Purpose::divisionPlane};
  CHECK(randomWords(draw, 0) == Words{0x0b14dd60, 0x1ee12ea9, 0xb5f28304, 0x69dc2aaf});
  CHECK(randomUnit(draw, 0) == (0x0b14dd601ee12ea9 >> 11) * 0x1p-53);
}

TEST_CASE("Every part of a draw counts") {
  const Draw base{1, CellPath::parse("AB"), 2, Purpose::test};
  std::set<Words> seen = {randomWords(base, 0)};
  CHECK(seen.insert(randomWords(base, 1)).second);
  for (Draw other : {Draw{2, base.cell, 2, Purpose::test}, Draw{1ull << 40 | 1, base.cell, 2, Purpose::test},
                     Draw{1, CellPath::parse("ABA"), 2, Purpose::test}, Draw{1, CellPath::parse("A"), 2, Purpose::test},
                     Draw{1, CellPath::parse("BA"), 2, Purpose::test}, Draw{1, base.cell, 3, Purpose::test},
                     Draw{1, base.cell, 2, Purpose::perturbation}, Draw{1, base.cell, 2, Purpose::divisionPlane}})
    CHECK(seen.insert(randomWords(other, 0)).second);
}

TEST_CASE("The order of draws does not matter") {
  std::vector<int> order(500);
  for (int i = 0; i < 500; ++i) order[i] = i;
  std::vector<Vector> forwards(500), mixed(500);
  for (int i : order) forwards[i] = randomDirection(drawOfCell(i));
  std::sort(order.begin(), order.end(),
            [](int a, int b) { return randomWords(drawOfCell(a), 9) < randomWords(drawOfCell(b), 9); });
  for (int i : order) mixed[i] = randomDirection(drawOfCell(i));
  CHECK(forwards == mixed);
}

TEST_CASE("A random unit lies in [0, 1), uniformly") {
  // The mean of n draws has the standard deviation √(1/12 n), the mean of their squares √(4/45 n). One seed in a
  // million deviates by five of these, and the seed is fixed.
  double sum = 0, squares = 0;
  std::vector<int> tenths(10, 0);
  for (int i = 0; i < many; ++i) {
    const double u = randomUnit(drawOfCell(i), 0);
    REQUIRE(u >= 0);
    REQUIRE(u < 1);
    sum += u;
    squares += u * u;
    ++tenths[static_cast<int>(u * 10)];
  }
  CHECK(std::abs(sum / many - 0.5) < 5 * std::sqrt(1.0 / 12 / many));
  CHECK(std::abs(squares / many - 1.0 / 3) < 5 * std::sqrt(4.0 / 45 / many));
  for (int n : tenths) CHECK(std::abs(n - many / 10.0) < 5 * std::sqrt(many * 0.1 * 0.9));
}

TEST_CASE("Numbers of one draw are uniform and not correlated with their successors") {
  double sum = 0, products = 0, before = 0.5;
  const Draw draw{7, {}, 0, Purpose::test};
  for (std::uint32_t i = 0; i < many; ++i) {
    const double u = randomUnit(draw, i);
    sum += u;
    products += (u - 0.5) * (before - 0.5);
    before = u;
  }
  CHECK(std::abs(sum / many - 0.5) < 5 * std::sqrt(1.0 / 12 / many));
  CHECK(std::abs(products / many) < 5 * std::sqrt(1.0 / 144 / many));
}

TEST_CASE("A random direction is made of the first pair of numbers inside the unit disc [Marsaglia 1972]") {
  int rejected = 0;
  for (int i = 0; i < 1000; ++i) {
    const Draw draw = drawOfCell(i);
    std::uint32_t pair = 0;
    double u = 0, v = 0;
    for (;; ++pair) {
      u = 2 * randomUnit(draw, 2 * pair) - 1, v = 2 * randomUnit(draw, 2 * pair + 1) - 1;
      if (u * u + v * v < 1) break;
    }
    rejected += pair > 0;
    const double s = u * u + v * v, root = 2 * std::sqrt(1 - s);
    REQUIRE(randomDirection(draw) == Vector{u * root, v * root, 1 - 2 * s});
  }
  CHECK(rejected > 100);  // expected: a share of 1 − π/4
}

TEST_CASE("Random directions are uniform on the sphere") {
  // A uniform direction has E x = 0, E x² = 1/3, E xy = 0, with the variances 1/3, 1/5 − 1/9 = 4/45 and 1/15 per draw.
  // Archimedes: each coordinate is uniform in [−1, 1].
  Vector sum;
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
  std::vector<std::array<int, 3>> eighths(8, {0, 0, 0});
  for (int i = 0; i < many; ++i) {
    const Vector d = randomDirection(drawOfCell(i));
    REQUIRE(std::abs(norm(d) - 1) < 1e-15);
    sum += d;
    xx += d.x * d.x, yy += d.y * d.y, zz += d.z * d.z;
    xy += d.x * d.y, yz += d.y * d.z, zx += d.z * d.x;
    int k = 0;
    for (double c : {d.x, d.y, d.z}) ++eighths[std::min(static_cast<int>((c + 1) * 4), 7)][k++];
  }
  const double meanTolerance = 5 * std::sqrt(1.0 / 3 / many);      // 0.0091
  const double squareTolerance = 5 * std::sqrt(4.0 / 45 / many);   // 0.0047
  const double productTolerance = 5 * std::sqrt(1.0 / 15 / many);  // 0.0041
  for (double s : {sum.x, sum.y, sum.z}) CHECK(std::abs(s / many) < meanTolerance);
  for (double s : {xx, yy, zz}) CHECK(std::abs(s / many - 1.0 / 3) < squareTolerance);
  for (double s : {xy, yz, zx}) CHECK(std::abs(s / many) < productTolerance);
  for (const auto& counts : eighths)
    for (int n : counts) CHECK(std::abs(n - many / 8.0) < 5 * std::sqrt(many * 0.125 * 0.875));
}

TEST_CASE("Normal deviates have the shares of the bell curve, and none beyond three") {
  constexpr int draws = 100'000;
  // Bounds of eight classes of the normal distribution cut at ±3.
  const double bounds[] = {-3, -1.5, -1, -0.5, 0, 0.5, 1, 1.5, 3};
  const auto below = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
  int count[8] = {};
  double squares = 0;
  for (int i = 0; i < draws; ++i) {
    const double z = randomNormal(drawOfCell(i));
    REQUIRE(std::abs(z) <= largestNormal);
    squares += z * z;
    for (int k = 0; k < 8; ++k) count[k] += z >= bounds[k] && z < bounds[k + 1];
  }
  double chiSquare = 0;
  for (int k = 0; k < 8; ++k) {
    const double expected = draws * (below(bounds[k + 1]) - below(bounds[k])) / (below(3) - below(-3));
    chiSquare += (count[k] - expected) * (count[k] - expected) / expected;
  }
  CHECK(chiSquare < 24.3);  // 7 degrees of freedom: one seed in a thousand exceeds this
  CHECK(std::sqrt(squares / draws) == Approx(0.98658).epsilon(0.01));
}

TEST_CASE("A normal deviate belongs to its draw and number") {
  const Draw draw{20080617, CellPath::parse("ABBA"), 3, Purpose::test};
  CHECK(randomNormal(draw) == randomNormal(draw, 0));
  std::set<double> seen;
  for (std::uint32_t number = 0; number < 100; ++number) CHECK(seen.insert(randomNormal(draw, number)).second);
}
