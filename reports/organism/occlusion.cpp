// Ambient occlusion: creases between cells get less light.
#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "base/parallel.h"
#include "organism/drawn_samples.h"

namespace morula {
namespace {

constexpr int turns = 16, taps = 18, lanes = 20;  // lanes beyond `taps` have weight 0
constexpr int spread[turns] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};  // [Bayer 1973]

/// The sampling places of a pixel, as shares of its reach: in steps of the golden angle outwards, turned by the pixel's
/// place in a 4 × 4 block.
struct Spiral {
  std::array<float, lanes> share{}, x{}, y{};
};

const std::array<Spiral, turns>& spirals() {
  static const std::array<Spiral, turns> all = [] {
    std::array<Spiral, turns> made;
    for (int turn = 0; turn < turns; ++turn)
      for (int i = 0; i < taps; ++i) {
        const double angle = 2.399963 * i + 6.283185 * (turn + 0.5) / turns;
        made[turn].share[i] = (float(i) + (float(turn) + 0.5f) / turns) / taps;
        made[turn].x[i] = float(std::cos(angle)), made[turn].y[i] = float(std::sin(angle));
      }
    return made;
  }();
  return all;
}

/// Returns max(x, 0), exactly and without a branch, so that loops are vectorised.
float positive(float x) { return 0.5f * (x + std::abs(x)); }

/// Rounds to the nearest integer, as the processor rounds sums; for |x| < 2^22.
float rounded(float x) {
  constexpr float shift = 12582912;  // 1.5 · 2^23, where a float's last place is 1
  return (x + shift) - shift;
}

}  // namespace

// Scalable ambient obscurance [McGuire, Mara, Luebke 2012]: nearby points above the tangent plane take light away, the
// more the nearer they are; none beyond `radius`.
void findOcclusion(Samples& samples, float radius, int y, const float* normals) {
  const float lastX = float(samples.width - 1), lastY = float(samples.height - 1),
              atX = samples.rayX(float(samples.middleOf(0))), atY = samples.rayY(float(samples.middleOf(0))),
              stepX = 2 * samples.apertureX / float(samples.width),
              stepY = 2 * samples.apertureY / float(samples.height), eye = samples.eyeDistance,
              square = radius * radius;
  for (int x = 0; x < samples.width; ++x) {
    const std::size_t here = samples.pixelAt(x, y);
    samples.visible[here] = 1;
    if (!isCell(samples.middles[here])) continue;
    const float pz = samples.heights[here], px = (atX + stepX * float(x)) * (eye - pz),
                py = (atY + stepY * float(y)) * (eye - pz);
    const float *n = normals + std::size_t(4) * samples.middleOf(x), nx = n[0], ny = n[1], nz = n[2];
    const float reach = 0.5f * float(samples.height) * radius / ((eye - pz) * samples.apertureY);  // [pixel]
    const Spiral& spiral = spirals()[spread[(y & 3) * 4 + (x & 3)]];
    float xs[lanes], ys[lanes], heights[lanes] = {}, taken[lanes];
    for (int i = 0; i < lanes; ++i) {
      const float far = reach * spiral.share[i];
      xs[i] = std::clamp(float(x) + rounded(far * spiral.x[i]), 0.0f, lastX);
      ys[i] = std::clamp(float(y) + rounded(far * spiral.y[i]), 0.0f, lastY);
    }
    for (int i = 0; i < taps; ++i) heights[i] = samples.heights[samples.pixelAt(int(xs[i]), int(ys[i]))];
    for (int i = 0; i < lanes; ++i) {
      const float away = eye - heights[i], dx = (atX + stepX * xs[i]) * away - px,
                  dy = (atY + stepY * ys[i]) * away - py, dz = heights[i] - pz;
      const float distance = dx * dx + dy * dy + dz * dz, rise = dx * nx + dy * ny + dz * nz;
      const float gap = positive(1 - distance / square);
      taken[i] = gap * gap * gap * positive(rise - 0.02f * radius) / (distance + 0.0004f * square);
    }
    float sum = 0;
    for (int i = 0; i < taps; ++i) sum += taken[i];
    samples.visible[here] = std::max(0.0f, 1 - 2.2f * radius * sum / taps);
  }
}

void evenOut(Samples& samples, int threads) {
  const int width = samples.width, height = samples.height, wide = width + 3;
  // `padded` repeats the border around the picture: two pixels before and one behind.
  const auto padded = [&](const auto& values) {
    std::remove_cvref_t<decltype(values)> result;
    for (int y = -2; y <= height; ++y) {
      const auto* row = &values[samples.pixelAt(0, std::clamp(y, 0, height - 1))];
      result.insert(result.end(), 2, row[0]);
      result.insert(result.end(), row, row + width);
      result.push_back(row[width - 1]);
    }
    return result;
  };
  const auto shown = padded(samples.middles);
  const auto shares = padded(samples.visible);
  parallelFor(height, threads, [&](int y) {
    std::vector<float> sums(width), weights(width);
    const std::uint32_t* own = &samples.middles[samples.pixelAt(0, y)];
    for (int from = y * wide, i = 0; i < 16; ++i) {
      const std::uint32_t* there = &shown[from + i / 4 * wide + i % 4];
      const float* share = &shares[from + i / 4 * wide + i % 4];
      for (int x = 0; x < width; ++x) {
        const float weight = there[x] == own[x] ? 1.0f : 0.0f;
        sums[x] += weight * share[x];
        weights[x] += weight;
      }
    }
    for (int x = 0; x < width; ++x) samples.visible[samples.pixelAt(x, y)] = sums[x] / weights[x];
  });
}

}  // namespace morula
