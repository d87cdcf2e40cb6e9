#include "comparison/picture_difference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/number_text.h"
#include "comparison/organism_pair.h"
#include "drawing/annotations.h"
#include "drawing/palette.h"
#include "image/colour_difference.h"

namespace morula {
namespace {

constexpr double deviation = 1.5;  // [pixel] standard deviation of the Gaussian
constexpr int reach = 6;           // [pixel] 4 deviations: less than 1e-4 of its weight lies beyond

/// Returns the weights of pixels 0 to `reach` away; the weights of both sides add up to 1.
std::array<double, reach + 1> weights() {
  std::array<double, reach + 1> w{};
  double sum = 0;
  for (int i = 0; i <= reach; ++i) {
    w[i] = std::exp(-0.5 * i * i / (deviation * deviation));
    sum += i ? 2 * w[i] : w[i];
  }
  for (double& x : w) x /= sum;
  return w;
}

using Pixels = std::vector<LinearColour>;

/// Smooths along rows or columns with the Gaussian. Beyond the edge the pixel at the edge repeats.
Pixels smoothAlong(const Pixels& in, int width, int height, bool rows) {
  static const auto weight = weights();
  Pixels out(in.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      LinearColour sum;
      for (int i = -reach; i <= reach; ++i) {
        const int xi = rows ? std::clamp(x + i, 0, width - 1) : x;
        const int yi = rows ? y : std::clamp(y + i, 0, height - 1);
        const LinearColour& c = in[static_cast<std::size_t>(yi) * width + xi];
        const double w = weight[std::abs(i)];
        sum.r += w * c.r, sum.g += w * c.g, sum.b += w * c.b;
      }
      out[static_cast<std::size_t>(y) * width + x] = sum;
    }
  return out;
}

Pixels smoothed(const Image& image) {
  Pixels pixels;
  pixels.reserve(image.pixels.size());
  for (const Colour c : image.pixels) pixels.push_back(linearColour(c));
  return smoothAlong(smoothAlong(pixels, image.width, image.height, true), image.width, image.height, false);
}

}  // namespace

bool PictureDifference::isNoticeable() const { return most > noticeableDifference; }

PictureDifference differenceOf(const Image& one, const Image& other) {
  if (one.width != other.width || one.height != other.height)
    throw InputError("pictures of " + std::to_string(one.width) + " x " + std::to_string(one.height) + " and " +
                     std::to_string(other.width) + " x " + std::to_string(other.height) +
                     " pixels cannot be compared; needs two of one size");
  PictureDifference difference;
  difference.map.assign(one.pixels.size(), 0);
  for (std::size_t i = 0; i < one.pixels.size(); ++i) difference.unequalPixels += one.pixels[i] != other.pixels[i];
  if (difference.unequalPixels == 0) return difference;
  const Pixels a = smoothed(one), b = smoothed(other);
  double sum = 0;
  std::size_t noticeable = 0, worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    // Equal pixels give exactly 0; the conversion to Lab is skipped.
    const bool same = a[i].r == b[i].r && a[i].g == b[i].g && a[i].b == b[i].b;
    const double d = same ? 0 : colourDifference(labOf(a[i]), labOf(b[i]));
    difference.map[i] = d;
    sum += d;
    noticeable += d > noticeableDifference;
    if (d > difference.map[worst]) worst = i;
  }
  difference.most = difference.map[worst];
  difference.x = static_cast<int>(worst % static_cast<std::size_t>(one.width));
  difference.y = static_cast<int>(worst / static_cast<std::size_t>(one.width));
  difference.mean = sum / static_cast<double>(a.size());
  difference.share = static_cast<double>(noticeable) / static_cast<double>(a.size());
  return difference;
}

Drawing drawPictureDifference(const Image& one, const Image& other, const PictureDifference& difference,
                              const std::vector<std::string>& notes) {
  // The scale ends at `noticeableDifference` or above, so that differences nobody sees do not glow.
  const double end = std::max(difference.most, noticeableDifference);
  Image map(one.width, one.height, paper);
  for (std::size_t i = 0; i < difference.map.size(); ++i) map.pixels[i] = scaleColour(difference.map[i] / end);
  constexpr int gap = 8;
  const Image sheet = contactSheet({one, other, map}, 3, gap, notes).pixels();
  const double size = textSizeFor(one.width, one.height);
  Drawing drawing(sheet.width, sheet.height + static_cast<int>(colourBarHeight(size) + size));
  drawing.image(0, 0, sheet);
  drawColourBar(drawing, {"difference ΔE00; noticed above " + numberText(noticeableDifference), 0, end},
                {2.0 * (one.width + gap) + gap, static_cast<double>(sheet.height)}, std::min(300.0, one.width * 0.8),
                size);
  return drawing;
}

}  // namespace morula
