// The width and place of texts, and the shortening of long ones.
#include <cstdlib>
#include <string>

#include "catch.h"
#include "drawing/drawing.h"
#include "drawing/drawn_text.h"
#include "pictures.h"

namespace morula {
namespace {

Extent inkBox(const std::string& text, const TextStyle& style) {
  Drawing drawing(200, 200);
  drawing.text({100, 100}, text, style);
  return extentOf(drawing.pixels(), isInk);
}

}  // namespace

TEST_CASE("text is as wide as textWidth says, and stands on its line", "[text]") {
  const TextStyle style{.size = 20};
  const double width = textWidth("Morula", style);
  CHECK(width > 40);
  CHECK(width < 90);
  CHECK(textWidth("MorulaMorula", style) == Approx(2 * width));
  CHECK(textWidth("Morula", {.size = 40}) == Approx(2 * width));
  const auto [left, right, top, bottom] = inkBox("Morula", style);
  CHECK(left >= 100);
  CHECK(right > 95 + width);
  CHECK(right < 101 + width);
  CHECK(top > 80);
  CHECK(bottom <= 100);
}

TEST_CASE("bold letters are wider", "[text]") { CHECK(textWidth("n", {.bold = true}) > textWidth("n", {})); }

TEST_CASE("anchors move text by its width, and upward text is the same text turned", "[text]") {
  const auto fromLeft = inkBox("AVm", {.size = 24});
  CHECK(fromLeft.left >= 99);
  CHECK(inkBox("AVm", {.size = 24, .anchor = Anchor::right}).right <= 100);
  const auto centred = inkBox("AVm", {.size = 24, .anchor = Anchor::centre});
  CHECK(std::abs(centred.left + centred.right - 200) <= 4);
  const auto upward = inkBox("AVm", {.size = 24, .upward = true});
  CHECK(upward.bottom <= 100);
  CHECK(std::abs((upward.bottom - upward.top) - (fromLeft.right - fromLeft.left)) <= 2);
  CHECK(upward.right <= 101);
}

TEST_CASE("letters are not moved to whole pixels", "[text]") {
  // A shift by half a pixel changes the picture; a shift by a whole pixel only moves it.
  const auto drawn = [](double x) {
    Drawing drawing(60, 30);
    drawing.text({x, 20}, "in", {.size = 13});
    return drawing.pixels();
  };
  const Image here = drawn(10), half = drawn(10.5), one = drawn(11);
  CHECK(half != here);
  CHECK(part(one, 1, 0, 59, 30) == part(here, 0, 0, 59, 30));
}

TEST_CASE("bytes that are not UTF-8 are drawn as U+FFFD", "[text]") {
  const TextStyle style{.size = 12};
  CHECK(textWidth("\xff", style) == textWidth("\uFFFD", style));
  CHECK(shortened("a\xff\xc3\x28\xe2\x82", style, 1000) == "a\uFFFD\uFFFD(\uFFFD\uFFFD");
  CHECK(shortened(std::string("a\0b", 3), style, 1000) == "a\uFFFDb");
  for (const PictureFormat format : {PictureFormat::png, PictureFormat::svg, PictureFormat::pdf}) {
    Drawing drawing(100, 30);
    drawing.text({5, 20}, "\xff\xc3\x28\xe2\x82 \x01\n", style);
    CHECK_NOTHROW(drawing.file(format));
  }
}

TEST_CASE("a text is shortened to the most letters that fit, whatever its length", "[text]") {
  const TextStyle style{.size = 14};
  for (const std::string letter : {"n", "ä", "AV", "i"}) {
    std::string word, longer;
    for (int i = 0; i < 40; ++i) word += letter;
    for (int i = 0; i < 1'000'000; ++i) longer += letter;
    for (const double width : {0.0, 5.0, 60.0, 200.0}) {
      CAPTURE(letter, width);
      const std::string few = shortened(word, style, width);
      CHECK(textWidth(few, style) <= width);
      CHECK((few.empty() || few == word || few.ends_with("…")));
      if (textWidth(word, style) <= width) {
        CHECK(few == word);
        continue;
      }
      CHECK(shortened(longer, style, width) == few);
      const std::string more = word.substr(0, few.size() < 3 ? letter.size() : few.size() - 3 + letter.size()) + "…";
      CHECK(textWidth(more, style) > width);
    }
  }
}

}  // namespace morula
