#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"

namespace morula {
namespace {

/// Linear light of every channel value; the one place that computes the transfer curve.
const std::array<double, 256>& linearTable() {
  static const std::array<double, 256> table = [] {
    std::array<double, 256> t;
    for (int i = 0; i < 256; ++i) {
      const double c = i / 255.0;
      t[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    return t;
  }();
  return table;
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

double linearLight(std::uint8_t channel) { return linearTable()[channel]; }

std::uint8_t channelOf(double linear) {
  const auto& table = linearTable();
  const auto above = std::lower_bound(table.begin(), table.end(), linear);
  if (above == table.begin()) return 0;
  if (above == table.end()) return 255;
  const auto below = above - 1;
  return std::uint8_t((linear - *below < *above - linear ? below : above) - table.begin());
}

Colour parseColour(std::string_view text) {
  const auto fail = [&] {
    throw InputError("'" + std::string(text) + "' is not a colour; write '#rrggbb', such as '#e41a1c'");
  };
  if (text.size() != 7 || text[0] != '#') fail();
  std::array<std::uint8_t, 3> channel;
  for (int i = 0; i < 3; ++i) {
    const int high = hexDigit(text[1 + 2 * i]), low = hexDigit(text[2 + 2 * i]);
    if (high < 0 || low < 0) fail();
    channel[i] = std::uint8_t(16 * high + low);
  }
  return {channel[0], channel[1], channel[2]};
}

std::string text(Colour colour) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string result = "#";
  for (const std::uint8_t channel : {colour.r, colour.g, colour.b}) {
    result += digits[channel >> 4];
    result += digits[channel & 15];
  }
  return result;
}

Colour mixColours(const std::vector<Colour>& colours) {
  if (colours.empty()) return neutralGrey;
  if (colours.size() == 1) return colours.front();
  // Counted per channel value and summed from dark to light, so that the order of the colours cannot move a
  // bit.
  std::array<std::array<int, 256>, 3> count{};
  for (const Colour& c : colours) ++count[0][c.r], ++count[1][c.g], ++count[2][c.b];
  std::array<std::uint8_t, 3> mean;
  for (int i = 0; i < 3; ++i) {
    double sum = 0;
    for (int value = 0; value < 256; ++value) sum += count[i][value] * linearTable()[value];
    mean[i] = channelOf(sum / double(colours.size()));
  }
  return {mean[0], mean[1], mean[2]};
}

}  // namespace morula
