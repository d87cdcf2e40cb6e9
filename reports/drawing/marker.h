#pragma once
// Marks of several shapes, so that what has a colour in a chart is told apart in grey, too.
#include <cstddef>

#include "drawing/drawing.h"

namespace morula {

enum class Marker { disc, square, triangle, diamond, hanging, plus, ring, cross };  // hanging: a triangle on its tip

/// Of series number i, counted from 0: no two of the first seven are alike; never a cross.
Marker seriesMarker(std::size_t i);

/// Around the centre, about as large as a disc of this radius.
void drawMarker(Drawing& drawing, Spot centre, double radius, Colour colour, Marker marker);

}  // namespace morula
