#pragma once
// Pixel images in memory.
#include <vector>

#include "image/colour.h"

namespace morula {

inline constexpr int maxSide = 16384;  // [pixel] max width and height
/// Throws InputError unless both sides of a picture are 1 to `maxSide` pixels.
void checkSides(int width, int height);

/// Pixels row by row from the top left.
struct Image {
  int width = 0, height = 0;
  std::vector<Colour> pixels;
  std::vector<std::uint8_t> opacity = {};  // one per pixel, 0 to 255; empty: all are opaque

  Image() = default;
  /// Throws InputError as checkSides does.
  Image(int width, int height, Colour fill);

  Colour& at(int x, int y) { return pixels[std::size_t(y) * width + x]; }
  const Colour& at(int x, int y) const { return pixels[std::size_t(y) * width + x]; }
  friend bool operator==(const Image&, const Image&) = default;
};

/// The background of pictures: near white, so that light cells stand out.
inline constexpr Colour paper{0xfa, 0xfa, 0xf8};

}  // namespace morula
