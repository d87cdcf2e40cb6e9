// What is drawn of a long text, and how much of it is looked at.
#include "catch.h"
#include "drawing/text.h"

using namespace morula;

TEST_CASE("of a text only as much is measured as there is room for") {
  const std::string text(1'000'000, 'n');
  const TextStyle style{.size = 14};
  const std::string_view beginning = beginningWiderThan(text, style, 300);
  CHECK(beginning.size() < 100);
  CHECK(textWidth(beginning, style) > 300);
  CHECK(beginningWiderThan("nn", style, 300) == "nn");
  CHECK(beginningWiderThan("", style, 300).empty());
}

TEST_CASE("a text is shortened to the most letters that fit, whatever its length") {
  const TextStyle style{.size = 14};
  for (const std::string letter : {"n", "ä", "AV", "i"}) {
    std::string word;
    for (int i = 0; i < 40; ++i) word += letter;
    std::string longer;
    for (int i = 0; i < 5000; ++i) longer += letter;
    for (const double width : {0.0, 5.0, 60.0, 200.0}) {
      CAPTURE(letter, width);
      const std::string few = shortened(word, style, width);
      CHECK(textWidth(few, style) <= width);
      if (textWidth(word, style) > width) CHECK(shortened(longer, style, width) == few);
      else CHECK(few == word);
    }
  }
}
