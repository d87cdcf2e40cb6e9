// Whether colours are told apart, by eyes of each kind.
#include "drawing/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "catch.h"

namespace morula {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple times(const Matrix& m, const Triple& v) {
  Triple result{};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) result[i] += m[i][k] * v[k];
  return result;
}

/// What eyes without one kind of cone see, in linear light [Machado et al. 2009, table 1, severity 1].
const Matrix eyes[] = {
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}};

/// CIE L*a*b* of a colour as these eyes see it.
Triple seen(const Matrix& eye, Colour c) {
  Triple light = times(eye, {linearLight(c.r), linearLight(c.g), linearLight(c.b)});
  for (double& a : light) a = std::clamp(a, 0.0, 1.0);
  Triple xyz = times({{{0.4124564, 0.3575761, 0.1804375},
                       {0.2126729, 0.7151522, 0.0721750},
                       {0.0193339, 0.1191920, 0.9503041}}},
                     light);
  const Triple white{0.95047, 1, 1.08883};
  for (int i = 0; i < 3; ++i) {
    const double t = xyz[i] / white[i];
    xyz[i] = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  }
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

double difference(const Matrix& eye, Colour a, Colour b) {
  const Triple x = seen(eye, a), y = seen(eye, b);
  return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

}  // namespace

TEST_CASE("the first series are told apart by all eyes, and on paper", "[palette]") {
  for (const Matrix& eye : eyes)
    for (std::size_t i = 0; i < fewSeries; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        CAPTURE(&eye - eyes, i, k);
        CHECK(difference(eye, seriesColour(i), seriesColour(k)) > 15);  // 2.3 is just noticeable
      }
      CHECK(difference(eye, seriesColour(i), {0xfa, 0xfa, 0xf8}) > 25);
    }
}

TEST_CASE("no two series have one colour", "[palette]") {
  for (std::size_t i = 0; i < manySeries; ++i)
    for (std::size_t k = 0; k < i; ++k) {
      CAPTURE(i, k);
      const Colour a = seriesColour(i), b = seriesColour(k);
      CHECK(std::hypot(a.r - b.r, a.g - b.g, a.b - b.b) > 25);
    }
}

TEST_CASE("the scale rises in lightness for all eyes, evenly enough", "[palette]") {
  for (const Matrix& eye : eyes)
    for (int i = 0; i < 16; ++i) {
      const double step = seen(eye, scaleColour((i + 1) / 16.0))[0] - seen(eye, scaleColour(i / 16.0))[0];
      CAPTURE(&eye - eyes, i);
      CHECK(step > 2);
      CHECK(step < 10);
    }
  // Equal steps look equal: no sixteenth of the way differs from another by more than a half.
  std::vector<double> steps;
  for (int i = 0; i < 16; ++i)
    steps.push_back(difference(eyes[0], scaleColour((i + 1) / 16.0), scaleColour(i / 16.0)));
  const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
  CHECK(*most < 2.5 * *least);  // CIE 1976 is itself not even to such a factor; viridis is so in CAM02-UCS
  CHECK(scaleColour(-1) == scaleColour(0));
  CHECK(scaleColour(2) == scaleColour(1));
}

}  // namespace morula
