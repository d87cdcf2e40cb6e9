#pragma once
// The instruments by which a picture is read: axes, a colour bar, the length of an arrow, a scale bar. They stand in a
// band of their own between the picture and its legend.
#include <optional>
#include <string>

#include "base/vec3.h"
#include "drawing/annotations.h"
#include "drawing/drawing.h"

namespace morula {

/// The arrow that stands for a round number of what arrows show.
struct ArrowKey {
  double lengthPerUnit = 1;  // [length] of an arrow that stands for 1; > 0
  std::string unit;          // "[force]"
  Colour colour;
};

struct Instruments {
  bool axes = false;      // which way x, y and z point
  bool scaleBar = false;  // a round length, at the depth of the picture's middle: what is nearer looks larger
  std::optional<ColourBar> colourBar;
  std::optional<ArrowKey> arrowKey;
  std::string lengthUnit = "[length]";  // that the scale bar's number is in
  double perLength = 1;                 // so many of it are one length; > 0
  bool any() const { return axes || scaleBar || colourBar || arrowKey; }
};

/// How space appears in a picture.
struct PictureScale {
  Vector x, y, z;          // the eye's axes
  double pixelsPerLength;  // [pixel/length] at the depth of the framing's centre
};

/// [pixel] The height of their band in a picture of this width, with ordinary text of this size. 0 for none.
int instrumentsHeight(const Instruments& instruments, int width, double textSize);

/// Draws them into the band that begins at y = `top`.
void drawInstruments(Drawing& drawing, const Instruments& instruments, const PictureScale& scale, double top,
                     double textSize);

/// The largest of the numbers 1, 2 and 5 times a power of ten that is not above `most` > 0.
double roundBelow(double most);

}  // namespace morula
