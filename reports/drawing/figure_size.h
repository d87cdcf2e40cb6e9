#pragma once
// The sizes of figures and of their words: the one place that decides them. A figure is laid out in pixels, with words
// of one size, and shown with pixels of the size that the words need: so lines and markers grow with the words.
#include <cmath>
#include <optional>

namespace morula {

/// Words of a figure have one of three sizes: titles, ordinary text, and small text. Beside ordinary text of 7 pt, as
/// journals ask for it, the others have 8 and 6 pt.
inline constexpr double titleText = 8.0 / 7, smallText = 6.0 / 7;  // [ordinary text]

/// The size [pixel] that ordinary text has in the layout of a figure whose font size is asked for.
inline constexpr double figureText = 13, dotsAsPixels = 0;  // 0: a pixel of the layout is a dot of the file

inline constexpr double screenDots = 96, printDots = 300;  // [dot/inch] of files of pixels

/// How a layout is shown.
struct Print {
  double textSize = 0;               // [pixel] of ordinary text; 0: what suits the picture
  double pixel = 72.0 / screenDots;  // [point] size of a pixel of the layout
  double resolution = screenDots;    // [dot/inch]
  bool onPaper() const { return resolution == printDots; }
  /// Returns the number of dots along a pixel's side in files of pixels.
  double dots() const { return pixel * resolution / 72; }
};

/// The size that a figure shall have.
struct FigureSize {
  double width = 0, height = 0;  // [mm] in print, else [pixel]; 0: what suits the figure
  bool inPrint = false;
  std::optional<double> font = {};  // [point] of ordinary text; absent: 7 in print, else what suits

  /// Sets `width`, `height` and `print` of a picture that is laid out with words of `textSize` pixels, or dotsAsPixels.
  /// A height that is not asked for is `ratio` of the width in print; 0: what suits.
  template <class Picture>
  void set(Picture& picture, double textSize, double ratio = 0) const {
    if (!(width > 0)) return;
    if (!inPrint && !font) {
      picture.width = int(width), picture.height = int(height);
      return;
    }
    Print& print = picture.print;
    print.resolution = inPrint ? printDots : screenDots;
    const double points = inPrint ? 72 / 25.4 : 72 / screenDots, size = font.value_or(7);
    if (textSize == dotsAsPixels) textSize = size * print.resolution / 72;
    picture.width = int(std::lround(width * points * textSize / size));
    print.pixel = width * points / picture.width;
    print.textSize = size / print.pixel;
    picture.height = int(std::lround(height > 0 ? height * points / print.pixel : ratio * picture.width));
  }
};

}  // namespace morula
