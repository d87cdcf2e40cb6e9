#pragma once
// A drawing keeps its lines, discs, words and pixels, and becomes pixels, PNG, SVG or PDF, by cairo. Coordinates are in
// pixels from the top left corner, y downwards; pixel (0, 0) covers 0 to 1. A pixel is 1/96 inch on a screen and as
// large as Print says on paper.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/drawn_text.h"
#include "drawing/figure_size.h"
#include "image/image.h"

namespace morula {

class Canvas;

struct Spot {
  double x = 0, y = 0;
};

struct Stroke {
  double width = 1;  // [pixel] below 1: the share of a pixel's ink
  Colour colour;
  bool dashed = false;
  double rounding = 0;  // [pixel] radius of rounded corners, at most half of a corner's sides
};

enum class PictureFormat { png, svg, pdf };

class Drawing {
 public:
  enum class Ground { paper, none };  // none: transparent where nothing is drawn
  /// Creates an empty drawing. Throws InputError as checkSides does.
  Drawing(int width, int height, Ground ground = Ground::paper, const Print& print = {});

  int width() const { return width_; }
  int height() const { return height_; }

  // Each element lies on top of earlier ones; parts outside of the paper are cut off.

  /// Draws a line through the points, with round ends and joints. Where the line crosses itself it is not darker.
  void line(const std::vector<Spot>& points, const Stroke& stroke);
  void disc(Spot centre, double radius, Colour colour);
  /// Fills the area that the closed line through the points encloses.
  void area(const std::vector<Spot>& points, Colour colour);
  void box(Spot topLeft, double width, double height, Colour colour);
  /// Draws UTF-8 text on one line, its baseline through the spot. Bytes that are not UTF-8 appear as U+FFFD.
  void text(Spot baseline, std::string_view text, const TextStyle& style);
  /// Draws the image, top left corner at (x, y); each of its pixels covers `pixel` times a pixel of the drawing.
  void image(double x, double y, const Image& image, double pixel = 1);

  Image pixels() const;

  /// Returns the content of a file. Equal drawings give equal bytes on one machine: files contain no date. Words are
  /// text in SVG and PDF; PDF holds the font's letters, SVG the width that words have in it.
  std::string file(PictureFormat format) const;

 private:
  void replay(Canvas& canvas) const;

  int width_, height_;
  Ground ground_;
  Print print_;
  std::vector<std::function<void(Canvas&)>> marks_;
};

/// Returns the place of a horizontal or vertical line one pixel wide that runs through the middle of a row or column,
/// so that it is crisp.
double crisp(double place);

}  // namespace morula
