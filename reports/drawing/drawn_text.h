#pragma once
// Text in drawings: width and shortening. The font is DejaVu Sans, or else the system's sans-serif. Letters are not
// hinted, so that text scales evenly; there is no kerning.
#include <string>
#include <string_view>
#include <vector>

#include "image/colour.h"

typedef struct _cairo cairo_t;

namespace morula {

enum class Anchor { left, centre, right };  // the end of the text that stands at the given place

struct TextStyle {
  double size = 14;  // [pixel] size of the em square
  Colour colour{0x22, 0x26, 0x2b};
  bool bold = false;
  Anchor anchor = Anchor::left;
  bool upward = false;  // reads from bottom to top
  double halo = 0;      // [pixel] width of paper around the letters, for text on a picture
};

/// Max number of letters of a text that are drawn; no picture has room for more.
inline constexpr std::size_t maxLetters = 8192;

/// Returns the text with U+FFFD for each byte that is not UTF-8, and at most maxLetters letters.
std::string validText(std::string_view text);

/// Returns the width of the text [pixel].
double textWidth(std::string_view text, const TextStyle& style);

/// Returns the text, shortened with an ellipsis to at most `width` pixels; empty if not even one letter fits.
std::string shortened(std::string_view text, const TextStyle& style, double width);

/// Returns the text's lines of at most `width` pixels, broken at blanks; at least one. A longer word is shortened.
std::vector<std::string> wrapped(std::string_view text, const TextStyle& style, double width);

/// Draws valid text for drawing.cpp, with its baseline through (x, y).
void showText(cairo_t* target, double x, double y, const std::string& text, const TextStyle& style);

}  // namespace morula
