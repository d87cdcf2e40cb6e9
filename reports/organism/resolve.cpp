// Composes the light of each pixel.
#include <algorithm>
#include <cmath>

#include "organism/drawn_samples.h"

namespace morula {
namespace {

constexpr int lightSteps = 1 << 16;  // the lowest sRGB level spans about twenty steps

/// Returns a table from linear light, in steps, to the nearest sRGB level, which saves a power for each pixel.
std::vector<std::uint8_t> levelsOfLight() {
  std::vector<std::uint8_t> levels(lightSteps + 1);
  for (int level = 1; level < 256; ++level) {
    const double c = (level - 0.5) / 255, least = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    std::fill(levels.begin() + int(std::ceil(least * lightSteps)), levels.end(), std::uint8_t(level));
  }
  return levels;
}

/// Returns the pixel's visibility. For a sample with another owner than the pixel's middle returns the mean of
/// neighbours with this owner.
float visibleAt(const Samples& samples, int x, int y, std::uint32_t owner) {
  if (owner == samples.middles[samples.pixelAt(x, y)]) return samples.visible[samples.pixelAt(x, y)];
  float sum = 0, weight = 0;
  for (int dy = std::max(y - 1, 0); dy <= std::min(y + 1, samples.height - 1); ++dy)
    for (int dx = std::max(x - 1, 0); dx <= std::min(x + 1, samples.width - 1); ++dx)
      if (samples.middles[samples.pixelAt(dx, dy)] == owner) sum += samples.visible[samples.pixelAt(dx, dy)], ++weight;
  return weight > 0 ? sum / weight : 0.7f;
}

/// Returns the factor of a cell's light that draws dark outlines: 1 inside, outlineShade where the cell ends.
float outlineAt(const Samples& samples, int column, int row, std::uint32_t owner) {
  const int reach = samples.outlineReach, right = std::min(column + reach, samples.columns() - 1),
            left = std::max(column - reach, 0), above = std::min(row + reach, samples.rows() - 1),
            below = std::max(row - reach, 0);
  for (const std::size_t there :
       {samples.at(right, row), samples.at(left, row), samples.at(column, above), samples.at(column, below)}) {
    const std::uint32_t other = samples.owners[there];
    if (other != owner && other != lineOwner) return outlineShade;
  }
  return 1;
}

Seen seenAt(const Samples& samples, int x, int y, const float* lights, const float (&ground)[3]) {
  float sum[3] = {}, covered = 0;
  for (int i = 0; i < samples.along * samples.along; ++i) {
    const int column = x * samples.along + i % samples.along, line = i / samples.along, row = y * samples.along + line;
    const std::size_t sample = samples.at(column, row);
    const std::uint32_t owner = samples.owners[sample];
    const float* light = owner != noOwner ? lights + 4 * samples.at(column, line) : ground;
    const float shade = isCell(owner) ? visibleAt(samples, x, y, owner) * outlineAt(samples, column, row, owner) : 1;
    const float* veil = samples.veils.empty() ? nullptr : &samples.veils[4 * sample];
    for (int c = 0; c < 3; ++c) {
      const float seen = veil ? veil[c] + (1 - veil[3]) * (light[c] * shade) : light[c] * shade;
      sum[c] += std::min(seen, 1.0f);
    }
    covered += owner != noOwner ? 1 : veil ? veil[3] : 0;
  }
  const float count = float(samples.along * samples.along);
  return {{sum[0] / count, sum[1] / count, sum[2] / count}, covered / count};
}

}  // namespace

void resolve(const Samples& samples, const std::optional<GlassShell>& shell, int y, const float* lights, Image& image) {
  static const std::vector<std::uint8_t> levels = levelsOfLight();
  const bool isTransparent = !image.opacity.empty();
  const float whole = isTransparent ? 0 : 1;
  const float ground[3] = {whole * float(linearLight(paper.r)), whole * float(linearLight(paper.g)),
                           whole * float(linearLight(paper.b))};
  std::vector<Seen> row(samples.width);
  for (int x = 0; x < samples.width; ++x) row[x] = seenAt(samples, x, y, lights, ground);
  if (shell) coverWithGlass(samples, *shell, y, row);
  const std::size_t first = samples.pixelAt(0, image.height - 1 - y);
  for (int x = 0; x < samples.width; ++x) {
    const Seen& seen = row[x];
    const float share = isTransparent ? std::max(seen.opacity, 1e-6f) : 1;
    const auto level = [&](float light) {
      return levels[std::size_t(std::clamp(light / share, 0.0f, 1.0f) * lightSteps + 0.5f)];
    };
    image.pixels[first + x] = {level(seen.light[0]), level(seen.light[1]), level(seen.light[2])};
    if (isTransparent) image.opacity[first + x] = std::uint8_t(std::lround(255 * seen.opacity));
  }
}

}  // namespace morula
