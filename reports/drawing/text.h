#pragma once
// Words in drawings: how wide they are and how they are shortened. The font is DejaVu Sans, or without it whatever the
// system calls sans-serif. Letters are not hinted, so that text scales evenly; there is no kerning.
#include <string>
#include <string_view>

#include "image/colour.h"

typedef struct _cairo cairo_t;

namespace morula {

enum class Anchor { left, centre, right };  // which end of the text stands at the given place

struct TextStyle {
  double size = 14;  // [pixel] of the em square
  Colour colour{0x22, 0x26, 0x2b};
  bool bold = false;
  Anchor anchor = Anchor::left;
  bool upward = false;  // reads from bottom to top
  double halo = 0;      // [pixel] of paper around the letters, for words that lie on a picture
};

/// Max number of letters of a text that are drawn; no picture has room for more.
inline constexpr std::size_t maxLetters = 8192;

/// How far the text runs. [pixel]
double textWidth(std::string_view text, const TextStyle& style);

/// The text, shortened with an ellipsis to the most letters that fit if it would run farther than `width`
/// pixels; empty if not even one and the ellipsis fit.
std::string shortened(std::string_view text, const TextStyle& style, double width);

/// Draws, for drawing.cpp, the text with its baseline through (x, y).
void showText(cairo_t* target, double x, double y, const std::string& text, const TextStyle& style);

}  // namespace morula
