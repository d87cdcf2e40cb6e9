#pragma once
// sRGB colours with 8 bits a channel, and the mixed colour of cells with several coloured substances.
#include <cstdint>
#include <string_view>
#include <vector>

namespace morula {

struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
  friend constexpr bool operator==(const Colour&, const Colour&) = default;
};

/// Returns the colour of 0xrrggbb.
constexpr Colour colourFrom(std::uint32_t rgb) {
  return {std::uint8_t(rgb >> 16), std::uint8_t(rgb >> 8), std::uint8_t(rgb)};
}

/// The colour of cells none of whose substances has a colour.
inline constexpr Colour neutralGrey{0xbd, 0xbd, 0xbd};

/// Reads "#rrggbb" in lower or upper case. Throws InputError for anything else.
Colour parseColour(std::string_view text);

/// Returns the average in linear light, as if the colours were lamps: red and green give yellow and not brown. Order
/// does not matter; no colours give neutralGrey.
Colour mixColours(const std::vector<Colour>& colours);

/// Convert an sRGB channel to linear light in [0, 1], and back to the nearest channel; values outside are clamped [IEC
/// 61966-2-1].
double linearLight(std::uint8_t channel);
std::uint8_t channelOf(double linear);

}  // namespace morula
