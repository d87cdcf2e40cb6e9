// Differences of pictures: computed by hand for simple ones, and ranked as people would see them.
#include "comparison/picture_difference.h"

#include <cmath>

#include "base/error.h"
#include "catch.h"
#include "pictures.h"

namespace morula {

namespace {

/// Returns CIELAB's lightness of a grey.
double lightness(int level) { return 116 * std::cbrt(std::pow((level / 255.0 + 0.055) / 1.055, 2.4)) - 16; }

}  // namespace

TEST_CASE("equal pictures have no difference, and those of other sizes none that can be told", "[comparison]") {
  const Image image = drawOrganism(picture({ball("A", {0, 0, 0}, 1, red)}));
  const PictureDifference same = differenceOf(image, image);
  CHECK(same.most == 0);
  CHECK(same.mean == 0);
  CHECK(same.unequalPixels == 0);
  CHECK_FALSE(same.isNoticeable());
  CHECK_THROWS_WITH(differenceOf(image, Image(120, 119, paper)),
                    ContainsSubstring("120 x 120 and 120 x 119") && ContainsSubstring("one size"));
}

TEST_CASE("between two even greys the difference is that of their lightness", "[comparison]") {
  // Without colour, only the term of lightness is left: ΔL / S_L.
  const double mean = (lightness(120) + lightness(130)) / 2 - 50;
  const double byHand = (lightness(130) - lightness(120)) / (1 + 0.015 * mean * mean / std::sqrt(20 + mean * mean));
  const PictureDifference d = differenceOf(Image(30, 20, {120, 120, 120}), Image(30, 20, {130, 130, 130}));
  CHECK(d.most == Approx(byHand).epsilon(1e-3));  // sRGB's white is grey to 4 digits
  CHECK(d.mean == Approx(byHand).epsilon(1e-3));
  CHECK(d.unequalPixels == 600);
  CHECK(d.share == 1);
  CHECK(d.isNoticeable());
}

TEST_CASE("where pictures differ is found, and only there", "[comparison]") {
  const Image one(40, 30, paper);
  Image other = one;
  for (int y = 18; y < 23; ++y)
    for (int x = 8; x < 13; ++x) other.at(x, y) = red;
  const PictureDifference d = differenceOf(one, other);
  CHECK(d.x == 10);
  CHECK(d.y == 20);
  CHECK(d.unequalPixels == 25);
  CHECK(d.isNoticeable());
  CHECK(differenceOf(other, one).most == Approx(d.most).epsilon(1e-9));
  // The Gaussian reaches six pixels.
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x)
      CHECK((d.map[std::size_t(y) * 40 + x] > 0) == (x >= 2 && x <= 18 && y >= 12 && y <= 28));
  const Drawing drawn = drawPictureDifference(one, other, d, {"a note"});
  const Image map = drawn.pixels();
  const auto darkest = map.at(2 * 48 + 8 + 30, 8 + 5), brightest = map.at(2 * 48 + 8 + 10, 8 + 20);
  CHECK(brightness(darkest) < 200);
  CHECK(brightness(brightest) > 400);
}

TEST_CASE("rounding is not noticed; a pixel's move, another colour and a missing cell are", "[comparison]") {
  const OrganismPicture scene = picture({ball("A", {-0.6, 0, 0}, 0.8, red), ball("B", {0.9, 0, 0}, 0.5, blue)});
  const Image image = drawOrganism(scene);
  Image rounded = image;
  for (std::size_t i = 0; i < rounded.pixels.size(); i += 2)
    if (rounded.pixels[i].g < 255) ++rounded.pixels[i].g;
  const PictureDifference rounding = differenceOf(image, rounded);
  CHECK(rounding.unequalPixels > 1000);
  CHECK_FALSE(rounding.isNoticeable());

  Image moved = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 1; x < image.width; ++x) moved.at(x, y) = image.at(x - 1, y);
  CHECK(differenceOf(image, moved).isNoticeable());

  OrganismPicture changed = scene;
  changed.cells[1].colour = {0x20, 0x60, 0xe0};
  CHECK(differenceOf(image, drawOrganism(changed)).isNoticeable());
  changed.cells.pop_back();
  CHECK(differenceOf(image, drawOrganism(changed)).isNoticeable());
}

}  // namespace morula
