#pragma once
// The perceived difference of two colours: CIEDE2000.
#include "image/colour.h"

namespace morula {

/// CIELAB of the 2° observer under D65 [CIE 15:2018]; L 0 (black) to 100 (white).
struct Lab {
  double L = 0, a = 0, b = 0;
};

/// Red, green and blue as linear light in [0, 1], with sRGB's primaries [IEC 61966-2-1].
struct LinearColour {
  double r = 0, g = 0, b = 0;
};

LinearColour linearColour(Colour colour);
Lab labOf(const LinearColour& colour);

/// Returns the difference ΔE00 of two colours, with all weights 1 [Sharma, Wu, Dalal 2005]. 0: equal; about 1: just
/// noticeable side by side; 100: black and white. Symmetric.
double colourDifference(const Lab& one, const Lab& other);

}  // namespace morula
