// Passes over the whole picture, on samples made by hand instead of by OpenGL.
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "organism/drawn_samples.h"

using namespace morula;

namespace {

/// Returns samples of a wall, one cell, at right angles to the view; a pixel has `along` × `along` samples.
Samples wall(int width, int height, int along) {
  Samples s{.width = width, .height = height, .along = along, .eyeDistance = 10, .apertureX = 0.2f, .apertureY = 0.2f};
  const std::size_t pixels = std::size_t(width) * height;
  s.owners.assign(pixels * along * along, 1), s.middles.assign(pixels, 1);
  s.heights.assign(pixels, 0), s.visible.assign(pixels, 1);
  return s;
}

void occlude(Samples& samples, float radius) {
  std::vector<float> normals(4 * samples.columns(), 0);
  for (int x = 0; x < samples.columns(); ++x) normals[4 * x + 2] = 1;
  for (int y = 0; y < samples.height; ++y) findOcclusion(samples, radius, y, normals.data());
}

Image resolved(const Samples& samples, float light, bool transparent = false,
               const std::optional<GlassShell>& shell = {}) {
  Image image(samples.width, samples.height, {});
  if (transparent) image.opacity.resize(image.pixels.size());
  const std::vector<float> lights(4 * samples.at(0, samples.along), light);
  for (int y = 0; y < samples.height; ++y) resolve(samples, shell, y, lights.data(), image);
  return image;
}

}  // namespace

TEST_CASE("A flat wall hides nothing of the sky from itself, and a step takes light from what lies at its foot") {
  Samples flat = wall(64, 48, 2);
  occlude(flat, 0.5f);
  CHECK(std::ranges::all_of(flat.visible, [](float v) { return v == 1; }));
  Samples step = wall(64, 64, 1);
  for (int y = 0; y < 64; ++y)
    for (int x = 32; x < 64; ++x) step.heights[step.pixelAt(x, y)] = 0.3f;
  occlude(step, 0.5f);
  evenOut(step, 1);
  const auto mean = [&](int x) {
    float sum = 0;
    for (int y = 16; y < 48; ++y) sum += step.visible[step.pixelAt(x, y)] / 32;
    return sum;
  };
  // A pixel is 0.0625 wide. The foot is darker; beyond the radius, and on the upper side, light is full.
  CHECK(mean(31) < 0.97f);
  CHECK(mean(20) == 1);
  CHECK(mean(40) == 1);
  // Returns the light that taps at all distances and in all directions would give; four columns are averaged.
  const auto expected = [](int x) {
    double sum = 0;
    for (int i = 0; i < 400; ++i)
      for (int k = 0; k < 400; ++k) {
        const double share = (i + 0.5) / 400, angle = 2 * 3.14159265 * k / 400, across = share * 0.5 * std::cos(angle);
        const double z = (x - 31.5) * 0.0625 + across > 0 ? 0.3 : 0,
                     dx = ((x - 31.5) * 0.0625 + across) * (1 - z / 10) - (x - 31.5) * 0.0625,
                     dy = share * 0.5 * std::sin(angle) * (1 - z / 10), squared = dx * dx + dy * dy + z * z,
                     gap = std::max(0.0, 1 - squared / 0.25);
        sum += gap * gap * gap * std::max(0.0, z - 0.01) / (squared + 0.0001) / 160000;
      }
    return 1 - 2.2 * 0.5 * sum;
  };
  for (const int x : {28, 30}) {  // 288 taps, rounded to pixels
    const double light = (expected(x - 2) + expected(x - 1) + expected(x) + expected(x + 1)) / 4;
    CHECK(1 - mean(x) == Approx(1 - light).epsilon(0.3));
  }
}

TEST_CASE("Evened out is the mean of sixteen pixels around that show the same, on any number of threads") {
  Samples samples = wall(13, 9, 1);
  for (std::size_t i = 0; i < samples.visible.size(); ++i) {
    samples.visible[i] = float(i * 2654435761u % 1000) / 1000;
    samples.middles[i] = std::uint32_t(i * 40503u / 64 % 3);
  }
  const Samples before = samples;
  evenOut(samples, 3);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 13; ++x) {
      double sum = 0, count = 0;
      for (int dy = -2; dy < 2; ++dy)
        for (int dx = -2; dx < 2; ++dx) {
          const std::size_t there = before.pixelAt(std::clamp(x + dx, 0, 12), std::clamp(y + dy, 0, 8));
          if (before.middles[there] == before.middles[before.pixelAt(x, y)]) sum += before.visible[there], ++count;
        }
      CHECK(samples.visible[samples.pixelAt(x, y)] == Approx(sum / count).epsilon(1e-5));
    }
}

TEST_CASE("Each level of sRGB comes back from its linear light") {
  for (int level = 0; level < 256; ++level) {
    const auto channel = std::uint8_t(level);
    const Image image = resolved(wall(1, 1, 2), float(linearLight(channel)));
    CHECK(image.at(0, 0) == Colour{channel, channel, channel});
    // Rounding goes to the nearest level that people see, not to the nearest light.
    for (const double off : {-0.4, 0.4}) {
      const double c = (level + off) / 255, light = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
      if (c > 0 && c < 1) CHECK(resolved(wall(1, 1, 1), float(light)).at(0, 0).r == level);
    }
  }
}

TEST_CASE("Where cells meet runs an outline; paper and what is transparent have none") {
  Samples samples = wall(8, 4, 1);
  for (int y = 0; y < 4; ++y)
    for (int x = 4; x < 8; ++x) samples.owners[samples.at(x, y)] = samples.middles[samples.pixelAt(x, y)] = 2;
  const Image image = resolved(samples, 0.5f);
  for (const int x : {3, 4}) CHECK(image.at(x, 2).r == channelOf(0.5 * outlineShade));
  for (const int x : {0, 1, 2, 5, 6, 7}) CHECK(image.at(x, 2).r == channelOf(0.5));
  std::ranges::fill(samples.owners, noOwner), std::ranges::fill(samples.middles, noOwner);
  CHECK(resolved(samples, 0.5f).at(1, 1) == paper);
  CHECK(resolved(samples, 0.5f, true).opacity == std::vector<std::uint8_t>(32, 0));
}

TEST_CASE("A sample of another cell than its pixel's middle sees as much of the sky as that cell's pixels around") {
  Samples samples = wall(3, 1, 2);
  for (const int row : {0, 1})
    for (const int column : {0, 1, 2}) samples.owners[samples.at(column, row)] = 2;
  samples.middles[0] = 2, samples.visible[0] = 0.5f;
  CHECK(resolved(samples, 0.8f).at(1, 0).r == channelOf(0.8 * outlineShade * (0.5 + 1) / 2));
}

TEST_CASE("A row from below is the image's row from the top, and a pixel the mean of its samples") {
  Samples samples = wall(3, 2, 2);
  for (int column : {4, 5}) samples.owners[samples.at(column, 3)] = noOwner;  // half of the upper right pixel
  const Image image = resolved(samples, 0, true);
  CHECK(image.opacity == std::vector<std::uint8_t>{255, 255, 128, 255, 255, 255});
}

TEST_CASE("Glass is nearly clear in its middle, denser at its rim, and nowhere beyond it") {
  Samples samples = wall(101, 101, 1);
  std::ranges::fill(samples.owners, noOwner), std::ranges::fill(samples.middles, noOwner);
  std::ranges::fill(samples.heights, -200.0f);
  const GlassShell ball{{1, 1, 1}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}};
  const Image image = resolved(samples, 0, false, ball), clear = resolved(samples, 0, true, ball);
  // The eye is at 10, so the ball's rim is at 10/√99 = 1.005: 25.4 pixels of 0.04 from the middle, pixel 50.
  const auto opacity = [&](int x) { return int(clear.opacity[std::size_t(50) * 101 + x]); };
  for (const int x : {0, 24, 76, 100}) CHECK(opacity(x) == 0);
  CHECK(image.at(24, 50) == paper);
  CHECK(opacity(50) <= 6);          // 0.02, and some highlight
  for (int x = 60; x <= 74; ++x) {  // pixels without the lamp's highlight
    const double u = (x - 50) * 4.0 / 101, nearest = 10 * u / std::sqrt(100 + u * u),
                 slant = 1 - std::sqrt(1 - nearest * nearest), s2 = slant * slant;
    CHECK(opacity(x) == Approx(255 * (0.02 + 0.12 * s2 + 0.46 * s2 * s2 * s2)).margin(0.6));
  }
  CHECK(opacity(26) == Approx(opacity(74)).margin(1));
  // The rim covers 0.25 of pixel 75, with the opacity at the rim.
  CHECK(opacity(75) == Approx(255 * 0.251 * 0.88).margin(2));
  // Parts in front of the shell are not seen through it.
  std::ranges::fill(samples.owners, 1), std::ranges::fill(samples.middles, 1);
  for (const float height : {0.5f, 5.0f}) {
    std::ranges::fill(samples.heights, height);
    const bool same = resolved(samples, 0.2f, false, ball).at(50, 50) == resolved(samples, 0.2f).at(50, 50);
    CHECK(same == (height > 1));
  }
}
