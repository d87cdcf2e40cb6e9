#include "drawing/marker.h"

#include <cmath>

namespace morula {
namespace {

/// A polygon around the centre, of points in units of the radius.
void drawShape(Drawing& drawing, Spot centre, double radius, Colour colour, std::vector<Spot> points) {
  for (Spot& p : points) p = {centre.x + radius * p.x, centre.y + radius * p.y};
  drawing.area(points, colour);
}

/// Two bars across each other, upright and level.
std::vector<Spot> bars(double reach, double half) {
  return {{-half, -reach}, {half, -reach}, {half, -half}, {reach, -half}, {reach, half},   {half, half},
          {half, reach},   {-half, reach}, {-half, half}, {-reach, half}, {-reach, -half}, {-half, -half}};
}

}  // namespace

Marker seriesMarker(std::size_t i) {
  constexpr Marker markers[] = {Marker::disc,    Marker::square, Marker::triangle, Marker::diamond,
                                Marker::hanging, Marker::plus,   Marker::ring};
  return markers[i % std::size(markers)];
}

void drawMarker(Drawing& drawing, Spot centre, double radius, Colour colour, Marker marker) {
  const auto shape = [&](const std::vector<Spot>& points) { drawShape(drawing, centre, radius, colour, points); };
  switch (marker) {
    case Marker::disc: return drawing.disc(centre, radius, colour);
    case Marker::square: return shape({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
    case Marker::triangle: return shape({{0, -1.3}, {1.2, 0.9}, {-1.2, 0.9}});
    case Marker::diamond: return shape({{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}});
    case Marker::hanging: return shape({{0, 1.3}, {1.2, -0.9}, {-1.2, -0.9}});
    case Marker::plus: return shape(bars(1.4, 0.45));
    case Marker::ring: drawing.disc(centre, 1.15 * radius, colour); return drawing.disc(centre, 0.6 * radius, paper);
    case Marker::cross: {
      std::vector<Spot> points = bars(1.4, 0.35);
      const double turn = std::sqrt(0.5);
      for (Spot& p : points) p = {turn * (p.x - p.y), turn * (p.x + p.y)};
      return shape(points);
    }
  }
}

}  // namespace morula
