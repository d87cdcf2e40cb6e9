// Lines, discs and images: amounts of ink, and files that hold the drawing.
#include "drawing/drawing.h"

#include <cairo.h>

#include <cstdint>
#include <cstring>
#include <string>

#include "base/error.h"
#include "catch.h"
#include "drawing/png_file.h"
#include "files/content.h"

namespace morula {
namespace {

/// Returns the ink of a picture in pixels of full black on paper.
double inkOf(const Image& image) {
  double sum = 0;
  for (const Colour& c : image.pixels) sum += double(paper.r - c.r) / paper.r;
  return sum;
}

constexpr Colour black{0, 0, 0};

Image speckled(int width, int height) {
  Image image(width, height, {});
  std::uint32_t x = 1;
  for (Colour& c : image.pixels) {
    x = x * 1664525u + 1013904223u;
    c = {std::uint8_t(x >> 24), std::uint8_t(x >> 16), std::uint8_t(x >> 8)};
  }
  return image;
}

Image readPng(const std::string& bytes) {
  std::string rest = bytes;
  const auto take = [](void* from, unsigned char* to, unsigned int length) {
    auto& text = *static_cast<std::string*>(from);
    if (text.size() < length) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(to, text.data(), length);
    text.erase(0, length);
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* surface = cairo_image_surface_create_from_png_stream(take, &rest);
  REQUIRE(cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS);
  Image image(cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {});
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      std::uint32_t p;
      std::memcpy(&p, cairo_image_surface_get_data(surface) + y * cairo_image_surface_get_stride(surface) + 4 * x, 4);
      image.at(x, y) = {std::uint8_t(p >> 16), std::uint8_t(p >> 8), std::uint8_t(p)};
    }
  cairo_surface_destroy(surface);
  return image;
}

/// Returns the check sum of a PNG chunk [PNG specification, annex D].
std::uint32_t crc(const std::string& bytes) {
  std::uint32_t sum = 0xFFFFFFFF;
  for (const char c : bytes) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = sum & 1 ? 0xEDB88320 ^ sum >> 1 : sum >> 1;
  }
  return ~sum;
}

constexpr PictureFormat formats[] = {PictureFormat::png, PictureFormat::svg, PictureFormat::pdf};

Drawing example() {
  Drawing drawing(200, 100);
  drawing.line({{10, 10}, {100, 10}, {100, 90}}, {.width = 3, .colour = black, .dashed = true, .rounding = 8});
  drawing.disc({150, 50}, 20, {0xe0, 0x20, 0x20});
  drawing.box({10, 40}, 12, 12, {0x20, 0x40, 0xe0});
  drawing.text({20, 80}, "Morula <b>&amp;", {.size = 20});
  return drawing;
}

}  // namespace

TEST_CASE("a line holds as much ink as its area, wherever it lies between the pixels", "[drawing]") {
  for (const double width : {0.4, 1.0, 3.0, 7.5})
    for (const double shift : {0.0, 0.25, 0.5, 0.9}) {
      Drawing drawing(100, 40);
      drawing.line({{20, 20 + shift}, {80, 20 + shift}}, {.width = width, .colour = black});
      CAPTURE(width, shift);
      // Ends are round, and cairo samples fifteen rows of a pixel.
      CHECK(inkOf(drawing.pixels()) == Approx(60 * width + 0.785 * width * width).margin(62.0 / 15));
    }
}

TEST_CASE("a rounded corner cuts off what a quarter circle leaves of its square", "[drawing]") {
  const auto corner = [](double rounding) {
    Drawing drawing(100, 100);
    drawing.line({{20, 20}, {80, 20}, {80, 80}}, {.width = 2, .colour = black, .rounding = rounding});
    return inkOf(drawing.pixels());
  };
  CHECK(corner(0) - corner(20) == Approx(2 * (40 - 3.14159 / 2 * 20)).epsilon(0.06));
  CHECK(corner(1000) == Approx(corner(30)));  // at most half of each side
}

TEST_CASE("a disc holds as much ink as its area", "[drawing]") {
  for (const double radius : {2.0, 5.0, 9.3}) {
    Drawing drawing(40, 40);
    drawing.disc({20.3, 19.8}, radius, black);
    CHECK(inkOf(drawing.pixels()) == Approx(3.14159265 * radius * radius).epsilon(0.02));
  }
}

TEST_CASE("joints are not darker than the line", "[drawing]") {
  Drawing drawing(60, 60);
  drawing.line({{10, 30}, {30, 30}, {30, 30}, {50, 30}}, {.width = 0.5, .colour = black});
  const Image image = drawing.pixels();
  for (int x = 20; x < 40; ++x) CHECK(image.at(x, 29) == image.at(20, 29));
}

TEST_CASE("two thirds of a dashed line are ink, and round ends", "[drawing]") {
  Drawing drawing(400, 20);
  drawing.line({{20, 10}, {380, 10}}, {.width = 2, .colour = black, .dashed = true});
  CHECK(inkOf(drawing.pixels()) == Approx(24 * (9 * 2 + 3.14159)).epsilon(0.03));  // 360 / (9 + 6) dashes
}

TEST_CASE("drawing beyond the edges is cut off", "[drawing]") {
  Drawing drawing(20, 20);
  drawing.line({{-50, 10}, {70, 10}}, {.width = 2, .colour = black});
  drawing.disc({-100, -100}, 5, black);
  drawing.line({}, {.width = 2, .colour = black});
  drawing.image(18, 18, Image(10, 10, paper));
  CHECK(inkOf(drawing.pixels()) == Approx(40).epsilon(0.01));
}

TEST_CASE("an image keeps its pixels wherever it lies", "[drawing]") {
  const Image speckles = speckled(7, 5);
  Drawing drawing(20, 20);
  drawing.image(3, 9, speckles);
  const Image image = drawing.pixels();
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) {
      const bool inside = x >= 3 && x < 10 && y >= 9 && y < 14;
      CHECK(image.at(x, y) == (inside ? speckles.at(x - 3, y - 9) : paper));
    }
}

TEST_CASE("pixels come back from PNG as they went, and equal images give equal files", "[drawing]") {
  for (const auto& [w, h] : {std::pair{1, 1}, {7, 3}, {256, 100}}) {
    const Image image = speckled(w, h);
    const std::string bytes = pngFile(image);
    CHECK(readPng(bytes) == image);
    CHECK(pngFile(image) == bytes);
  }
  CHECK_THROWS_AS(pngFile(Image()), InputError);
}

TEST_CASE("a PNG says that Morula made it, in a chunk whose check sum is right", "[drawing]") {
  const std::string bytes = pngFile(speckled(3, 3)), chunk = std::string("tEXtSoftware\0Morula", 19);
  const auto at = bytes.find(chunk);
  REQUIRE(at == 8 + 25 + 4);
  std::uint32_t sum = 0;
  for (int i = 0; i < 4; ++i) sum = sum << 8 | static_cast<unsigned char>(bytes[at + chunk.size() + i]);
  CHECK(sum == crc(chunk));
  CHECK(isOwnPng(bytes.substr(0, 64)));
  CHECK_FALSE(isOwnPng(bytes.substr(0, 40)));
  CHECK_FALSE(isOwnPng(std::string(bytes).replace(at + 14, 1, "N")));
  CHECK_FALSE(isOwnPng(""));
}

TEST_CASE("equal drawings give equal files, which say that they are pictures", "[drawing]") {
  for (const PictureFormat format : formats) {
    const std::string bytes = example().file(format);
    CHECK(example().file(format) == bytes);
    CHECK(contentOf(bytes) == Content::picture);
    Drawing other = example();
    other.disc({30, 30}, 3, black);
    CHECK(other.file(format) != bytes);
  }
}

TEST_CASE("SVG and PDF hold lines and text and no pixels, and no date", "[drawing]") {
  const std::string svg = example().file(PictureFormat::svg), pdf = example().file(PictureFormat::pdf);
  CHECK(svg.find("width=\"200px\" height=\"100px\"") != svg.npos);
  CHECK(svg.find("<image") == svg.npos);
  CHECK(svg.find("<b>") == svg.npos);
  CHECK(svg.find(">Morula &lt;b&gt;&amp;amp;</text>") != svg.npos);  // words do not become markup
  CHECK(svg.find("stroke-dasharray") != svg.npos);
  CHECK(svg.ends_with("</svg>\n"));
  CHECK(pdf.find("/MediaBox [ 0 0 150 75 ]") != pdf.npos);
  CHECK(pdf.find("/Subtype /Image") == pdf.npos);
  CHECK(pdf.find("(Morula)") != pdf.npos);
  CHECK(pdf.find("Date") == pdf.npos);
}

TEST_CASE("no mark goes on from the one before it", "[drawing]") {
  const auto lastPath = [](const Drawing& drawing) {
    const std::string svg = drawing.file(PictureFormat::svg);
    return svg.substr(svg.rfind("<circle"));
  };
  Drawing alone(100, 100), after(100, 100);
  alone.disc({70, 70}, 5, black);
  after.text({10, 20}, "A", {});
  after.disc({70, 70}, 5, black);
  CHECK(lastPath(after) == lastPath(alone));
}

TEST_CASE("a drawing's sides are checked", "[drawing]") {
  for (const auto& [w, h] : {std::pair{0, 5}, {5, 0}, {-1, 5}, {16385, 1}}) {
    CHECK_THROWS_AS(Drawing(w, h), InputError);
    CHECK_THROWS_AS(Image(w, h, paper), InputError);
  }
}

}  // namespace morula
