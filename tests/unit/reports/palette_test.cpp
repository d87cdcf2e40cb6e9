// Colours that eyes of each kind tell apart.
#include "drawing/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "catch.h"
#include "drawing/annotations.h"
#include "image/colour_difference.h"

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

/// Eyes without one kind of cone, as maps of linear light [Machado et al. 2009, table 1, severity 1].
const Matrix eyes[] = {
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}};

/// Returns a colour as these eyes see it.
Lab seen(const Matrix& eye, Colour c) {
  Triple light = times(eye, {linearLight(c.r), linearLight(c.g), linearLight(c.b)});
  for (double& a : light) a = std::clamp(a, 0.0, 1.0);
  return labOf({light[0], light[1], light[2]});
}

double difference(const Matrix& eye, Colour a, Colour b) {
  const Lab x = seen(eye, a), y = seen(eye, b);
  return std::hypot(x.L - y.L, x.a - y.a, x.b - y.b);
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

TEST_CASE("series with one marker are told apart in grey and with colour blindness", "[palette]") {
  for (std::size_t i = 0; i < manySeries; ++i)
    for (std::size_t k = 0; k < i; ++k) {
      if (seriesMarker(i) != seriesMarker(k)) continue;  // the pattern that tells them apart
      for (const Matrix& eye : {eyes[0], eyes[1], eyes[2]}) {
        CAPTURE(i, k);
        CHECK(difference(eye, seriesColour(i), seriesColour(k)) >= 10);
      }
      CHECK(std::abs(seen(eyes[0], seriesColour(i)).L - seen(eyes[0], seriesColour(k)).L) >= 10);
    }
}

TEST_CASE("clones are told apart by all eyes and, of three divisions, in grey", "[palette]") {
  const auto founders = [](int divisions) {
    std::vector<std::string> paths{""};
    for (int d = 0; d < divisions; ++d) {
      std::vector<std::string> next;
      for (const std::string& path : paths) next.push_back(path + "A"), next.push_back(path + "B");
      paths = next;
    }
    return paths;
  };
  for (const int divisions : {1, 2, 3, 4}) {
    const auto paths = founders(divisions);
    for (const Matrix& eye : eyes)
      for (std::size_t i = 0; i < paths.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
          const Colour a = cloneColour(paths[i]), b = cloneColour(paths[k]);
          CAPTURE(&eye - eyes, paths[i], paths[k]);
          CHECK(difference(eye, a, b) > (divisions < 4 ? 25 : 10));
          if (&eye == eyes && divisions < 4)
            CHECK(std::abs(seen(eye, a).L - seen(eye, b).L) > (divisions < 3 ? 20 : 10));
        }
        // Bound: six times a just noticeable difference, as cells have dark rims; the lightest clone has 17.7.
        CHECK(difference(eye, cloneColour(paths[i]), {0xfa, 0xfa, 0xf8}) > 15);
      }
  }
}

TEST_CASE("a clone has one colour, whatever else there is, and no two that live together share it", "[palette]") {
  CHECK(cloneColour("") == cloneColour("A"));
  CHECK(cloneColour("BA") == cloneColour("B"));
  CHECK(cloneColour("ABBAB") == cloneColour("ABBA"));  // only four letters count
  // Daughters differ in colour, from the egg on: daughter B takes a colour that no other cell has yet.
  for (const std::string path : {"", "A", "B", "AB", "BB", "ABA", "BBB"})
    CHECK(!(cloneColour(path + "A") == cloneColour(path + "B")));
  CHECK(!(cloneColour("B") == cloneColour("AB")));  // while B has not divided
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
      const double step = seen(eye, scaleColour((i + 1) / 16.0)).L - seen(eye, scaleColour(i / 16.0)).L;
      CAPTURE(&eye - eyes, i);
      CHECK(step > 2);
      CHECK(step < 10);
    }
  // Equal steps look equal: no sixteenth of the scale looks 2.5 times as large as another.
  std::vector<double> steps;
  for (int i = 0; i < 16; ++i) steps.push_back(difference(eyes[0], scaleColour((i + 1) / 16.0), scaleColour(i / 16.0)));
  const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
  CHECK(*most < 2.5 * *least);  // CIE 1976 itself is not more even; viridis is even in CAM02-UCS
  CHECK(scaleColour(-1) == scaleColour(0));
  CHECK(scaleColour(2) == scaleColour(1));
}

}  // namespace morula
