#include "drawing/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace morula {

Colour seriesColour(std::size_t i) {
  static constexpr std::array<Colour, manySeries> colours{{
      {0x00, 0x72, 0xb2}, {0xd5, 0x5e, 0x00}, {0x00, 0x9e, 0x73}, {0xcc, 0x79, 0xa7}, {0xe6, 0x9f, 0x00},
      {0x56, 0xb4, 0xe9}, {0x1c, 0x1c, 0x1c}, {0x6a, 0x3d, 0x9a}, {0x77, 0x77, 0x77}, {0xb1, 0x59, 0x28},
      {0x5c, 0x8a, 0x3a}, {0xc0, 0x1c, 0x3b}, {0x45, 0x6a, 0xd4}, {0x7a, 0x3e, 0x12}, {0xa8, 0xb4, 0x2a},
      {0x80, 0x00, 0x20}, {0x0b, 0x3c, 0x6f}, {0xff, 0x7a, 0x6b}, {0x00, 0xc0, 0xa0}, {0xc4, 0x26, 0xcf},
      {0x9b, 0x86, 0x62}, {0x2a, 0x4a, 0x2a}, {0x86, 0xa4, 0xd8}, {0x5c, 0x5a, 0x14},
  }};
  return colours[i % colours.size()];
}

Colour scaleColour(double share) {
  // viridis at every sixteenth of its way [van der Walt & Smith 2015, CC0]; the mean of two neighbours is off
  // by 6 of 255 at most.
  static constexpr std::array<Colour, 17> scale{{{0x44, 0x01, 0x54},
                                                 {0x48, 0x18, 0x6a},
                                                 {0x47, 0x2d, 0x7b},
                                                 {0x42, 0x40, 0x86},
                                                 {0x3b, 0x52, 0x8b},
                                                 {0x33, 0x63, 0x8d},
                                                 {0x2c, 0x72, 0x8e},
                                                 {0x26, 0x82, 0x8e},
                                                 {0x21, 0x91, 0x8c},
                                                 {0x1f, 0xa0, 0x88},
                                                 {0x28, 0xae, 0x80},
                                                 {0x3f, 0xbc, 0x73},
                                                 {0x5e, 0xc9, 0x62},
                                                 {0x84, 0xd4, 0x4b},
                                                 {0xad, 0xdc, 0x30},
                                                 {0xd8, 0xe2, 0x19},
                                                 {0xfd, 0xe7, 0x25}}};
  const double place = std::clamp(share, 0.0, 1.0) * (scale.size() - 1);
  const std::size_t i = std::min(std::size_t(place), scale.size() - 2);
  const auto mix = [t = place - double(i)](std::uint8_t a, std::uint8_t b) {
    return std::uint8_t(std::lround(a + t * (b - a)));
  };
  const Colour &a = scale[i], &b = scale[i + 1];
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

}  // namespace morula
