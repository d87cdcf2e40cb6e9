#include "image/colour_difference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morula {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Returns CIELAB's f: the cube root, continued by a straight line near 0 [CIE 15:2018].
double lightness(double share) {
  constexpr double knee = 6.0 / 29;
  return share > knee * knee * knee ? std::cbrt(share) : share / (3 * knee * knee) + 4.0 / 29;
}

double pow7(double x) { return x * x * x * x * x * x * x; }

/// Returns sqrt(C⁷ / (C⁷ + 25⁷)): 0 for greys, towards 1 for vivid colours.
double vividness(double chroma) {
  const double c7 = pow7(chroma);
  return std::sqrt(c7 / (c7 + pow7(25)));
}

/// Returns the angle of (a, b) in [0°, 360°); 0 for greys.
double hueOf(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double angle = std::atan2(b, a) / degree;
  return angle < 0 ? angle + 360 : angle;
}

}  // namespace

LinearColour linearColour(Colour c) { return {linearLight(c.r), linearLight(c.g), linearLight(c.b)}; }

Lab labOf(const LinearColour& c) {
  // XYZ relative to the white point: each row is divided by its sum, so that white is (1, 1, 1).
  const double x = (0.4124564 * c.r + 0.3575761 * c.g + 0.1804375 * c.b) / 0.95047;
  const double y = 0.2126729 * c.r + 0.7151522 * c.g + 0.0721750 * c.b;
  const double z = (0.0193339 * c.r + 0.1191920 * c.g + 0.9503041 * c.b) / 1.08883;
  const double fx = lightness(x), fy = lightness(y), fz = lightness(z);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

// The names are those of [Sharma, Wu, Dalal 2005], equations 2 to 22.
double colourDifference(const Lab& one, const Lab& other) {
  const double g = 0.5 * (1 - vividness((std::hypot(one.a, one.b) + std::hypot(other.a, other.b)) / 2));
  const double a1 = (1 + g) * one.a, a2 = (1 + g) * other.a;
  const double c1 = std::hypot(a1, one.b), c2 = std::hypot(a2, other.b);
  const double h1 = hueOf(a1, one.b), h2 = hueOf(a2, other.b);
  const bool grey = c1 * c2 == 0;

  double dh = grey ? 0 : h2 - h1;
  if (dh > 180) dh -= 360;
  else if (dh < -180) dh += 360;
  const double dL = other.L - one.L, dC = c2 - c1, dH = 2 * std::sqrt(c1 * c2) * std::sin(dh / 2 * degree);

  const double meanL = (one.L + other.L) / 2, meanC = (c1 + c2) / 2;
  double meanH = h1 + h2;  // a grey has no hue: the other colour's counts
  if (!grey) {
    if (std::abs(h1 - h2) > 180) meanH += meanH < 360 ? 360 : -360;
    meanH /= 2;
  }
  const double t = 1 - 0.17 * std::cos((meanH - 30) * degree) + 0.24 * std::cos(2 * meanH * degree) +
                   0.32 * std::cos((3 * meanH + 6) * degree) - 0.20 * std::cos((4 * meanH - 63) * degree);
  const double bend = (meanH - 275) / 25;
  const double rotation = -2 * vividness(meanC) * std::sin(60 * std::exp(-bend * bend) * degree);
  const double offMiddle = (meanL - 50) * (meanL - 50);
  const double l = dL / (1 + 0.015 * offMiddle / std::sqrt(20 + offMiddle)), c = dC / (1 + 0.045 * meanC),
               h = dH / (1 + 0.015 * meanC * t);
  return std::sqrt(std::max(0.0, l * l + c * c + h * h + rotation * c * h));
}

}  // namespace morula
