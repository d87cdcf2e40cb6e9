#pragma once
// The scales of a picture: axes, a colour bar, the length of an arrow, a scale bar. They stand in a band between the
// picture and its legend.
#include <optional>
#include <string>

#include "base/vec3.h"
#include "drawing/annotations.h"
#include "drawing/drawing.h"

namespace morula {

/// A key that shows the length of an arrow for a round number of units.
struct ArrowKey {
  double lengthPerUnit = 1;  // [length] of an arrow for one unit; > 0
  std::string unit;          // "[force]"
  Colour colour;
};

struct Instruments {
  bool axes = false;      // shows the directions of x, y and z
  bool scaleBar = false;  // shows a round length at the depth of the framing's centre; nearer things look larger
  std::optional<ColourBar> colourBar;
  std::optional<ArrowKey> arrowKey;
  std::string lengthUnit = "[length]";  // unit of the scale bar
  double perLength = 1;                 // number of these units in one length; > 0
  bool any() const { return axes || scaleBar || colourBar || arrowKey; }
};

/// The projection of space onto a picture.
struct PictureScale {
  Vector x, y, z;          // the eye's axes
  double pixelsPerLength;  // [pixel/length] at the depth of the framing's centre
};

/// Returns the height [pixel] of the band of instruments for a picture of this width and text size; 0 without any.
int instrumentsHeight(const Instruments& instruments, int width, double textSize);

/// Draws the instruments into the band that begins at y = `top`.
void drawInstruments(Drawing& drawing, const Instruments& instruments, const PictureScale& scale, double top,
                     double textSize);

/// Returns the largest of the numbers 1, 2 and 5 times a power of ten that is not above `most` > 0.
double roundBelow(double most);

}  // namespace morula
