#include "image/colour.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/error.h"

namespace morula {
namespace {

/// Returns the linear light of every channel value. No other function computes the transfer curve.
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
  unsigned value = 0;
  const char* end = text.data() + text.size();
  if (text.size() != 7 || text[0] != '#' || std::from_chars(text.data() + 1, end, value, 16).ptr != end)
    throw InputError("'" + std::string(text) + "' is not a colour; write '#rrggbb', such as '#e41a1c'");
  return colourFrom(value);
}

Colour mixColours(const std::vector<Colour>& colours) {
  if (colours.empty()) return neutralGrey;
  if (colours.size() == 1) return colours.front();
  // Colours are counted per channel value and summed from dark to light, so that their order does not affect the
  // result.
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
