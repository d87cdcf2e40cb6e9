#include "drawing/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace morula {

Colour seriesColour(std::size_t i) {
  static constexpr std::array<std::uint32_t, manySeries> colours{
      0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00, 0x56b4e9, 0x1c1c1c, 0x9b8662,
      0x800020, 0x456ad4, 0xb15928, 0x5c5a14, 0x6a3d9a, 0xff7a6b, 0xa8b42a, 0x86a4d8,
      0x0b3c6f, 0x2a4a2a, 0x777777, 0x5c8a3a, 0xc426cf, 0x7a3e12, 0xc01c3b, 0x00c0a0};
  return colourFrom(colours[i % colours.size()]);
}

Colour cloneColour(std::string_view founder) {
  static constexpr std::array<std::uint32_t, 1 << maxFounders> colours{
      0x4a267a, 0xba4802, 0x85a1f2, 0xffda51, 0x472ae1, 0x4e0024, 0x808c61, 0x15d7c5,
      0x69c33c, 0xff0096, 0xff96b4, 0x005a69, 0xff004b, 0x0f4b00, 0xc35ac3, 0xffb478};
  std::size_t number = 0;
  for (std::size_t i = 0; i < std::min(founder.size(), maxFounders); ++i)
    if (founder[i] == 'B') number |= std::size_t{1} << i;
  return colourFrom(colours[number]);
}

Colour scaleColour(double share) {
  // viridis at 17 equally spaced places [van der Walt & Smith 2015, CC0]; linear interpolation is off by at most 6 of
  // 255.
  static constexpr std::array<std::uint32_t, 17> scale{0x440154, 0x48186a, 0x472d7b, 0x424086, 0x3b528b, 0x33638d,
                                                       0x2c728e, 0x26828e, 0x21918c, 0x1fa088, 0x28ae80, 0x3fbc73,
                                                       0x5ec962, 0x84d44b, 0xaddc30, 0xd8e219, 0xfde725};
  const double place = std::clamp(share, 0.0, 1.0) * (scale.size() - 1);
  const std::size_t i = std::min(std::size_t(place), scale.size() - 2);
  const auto mix = [t = place - double(i)](std::uint8_t a, std::uint8_t b) {
    return std::uint8_t(std::lround(a + t * (b - a)));
  };
  const Colour a = colourFrom(scale[i]), b = colourFrom(scale[i + 1]);
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

}  // namespace morula
