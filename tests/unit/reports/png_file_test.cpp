// PNG files that are read back, and files that are refused.
#include "drawing/png_file.h"

#include <sys/resource.h>

#include "base/error.h"
#include "catch.h"
#include "drawing/drawing.h"

namespace morula {

namespace {

Image speckled() {
  Image image(17, 9, paper);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = {std::uint8_t(i * 37), std::uint8_t(i * 91), std::uint8_t(i * 53)};
  return image;
}

}  // namespace

TEST_CASE("pixels are read as they were written; what shines through lies on paper", "[drawing]") {
  Image image = speckled();
  CHECK(readPng(pngFile(image), "one.png") == image);
  image.opacity.assign(image.pixels.size(), 255);
  image.opacity[3] = 0, image.opacity[4] = 128;
  const Image read = readPng(pngFile(image), "one.png");
  CHECK(read.opacity.empty());
  CHECK(read.pixels[2] == image.pixels[2]);
  CHECK(read.pixels[3] == paper);
  const double half = (128 * image.pixels[4].g + 127 * paper.g) / 255.0;
  CHECK(read.pixels[4].g == Approx(half).margin(1.5));  // half is rounded twice
}

TEST_CASE("what is no PNG picture is refused by name", "[drawing]") {
  const std::string whole = pngFile(speckled());
  const auto refused = [](const std::string& bytes, const std::string& words) {
    CHECK_THROWS_WITH(readPng(bytes, "one.png"), ContainsSubstring("one.png: ") && ContainsSubstring(words));
  };
  refused("", "not a PNG");
  refused("a scenario, or any other text that is long enough", "not a PNG");
  refused(whole.substr(0, 20), "not a PNG");
  refused(whole.substr(0, whole.size() / 2), "damaged");
  std::string other = whole;
  other[60] = char(other[60] ^ 0x55);
  refused(other, "damaged");
  std::string large = whole;
  large[17] = large[21] = 1;                 // 65536 + 17 by 65536 + 9 pixels
  large.replace(29, 4, "\x0c\x85\x1c\xaa");  // the header's checksum [PNG specification, 5.3]
  refused(large, "too large");
  std::string wide = whole;
  wide[18] = 0x40;  // 16384 + 17 by 9 pixels
  wide.replace(29, 4, std::string("\x8d\xc2\x49\xb4", 4));
  refused(wide, "16384 along a side");
  std::string flat = whole;
  flat[19] = 0;  // zero width
  refused(flat, "damaged");
}

TEST_CASE("what a chunk says of its size takes no memory", "[drawing]") {
  std::string promising = pngFile(speckled());
  const std::size_t text = promising.find("tEXt");
  REQUIRE(text != promising.npos);
  promising[text - 4] = 0x60;  // claims 1.5 GiB
  const auto peak = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;  // [KiB]
  };
  const long before = peak();
  CHECK_THROWS_WITH(readPng(promising, "one.png"), ContainsSubstring("damaged"));
  CHECK(peak() - before < 100'000);
}

}  // namespace morula
