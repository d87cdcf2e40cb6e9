#pragma once
// Words in pictures (the only user of FreeType). Without a font there are no words, and nothing else changes.
#include <string>
#include <string_view>

#include "image/image.h"

namespace morula {

enum class Anchor { left, centre, right };  // which end of the text stands at the given place

struct TextStyle {
  double size = 14;  // [pixel] of the em square
  Colour colour{0x22, 0x26, 0x2b};
  bool bold = false;
  Anchor anchor = Anchor::left;
  bool upward = false;  // reads from bottom to top
};

/// Draws UTF-8 text on one line with its baseline through (x, y) [pixel from the top left]. Bytes that are
/// not UTF-8 appear as U+FFFD. What falls outside the image is cut off.
void drawText(Image& image, double x, double y, std::string_view text, const TextStyle& style);

/// How far the text runs. [pixel] 0 without a font.
double textWidth(std::string_view text, const TextStyle& style);

/// So many of its letters that they run a little farther than `width` pixels, or all: what there is to
/// measure of a text, however long it is.
std::string_view beginningWiderThan(std::string_view text, const TextStyle& style, double width);

/// The text, shortened with an ellipsis if it would run farther than `width` pixels; empty if not even that
/// fits.
std::string shortened(std::string_view text, const TextStyle& style, double width);

/// The file of DejaVu Sans, from the places where systems keep it; "" if it is not there.
std::string findFont(bool bold);

}  // namespace morula
