#pragma once
// Which cells touch, by their places and volumes alone.
#include <array>
#include <utility>
#include <vector>

#include "base/vec3.h"

namespace morula::tracks {

struct Ball {
  Point centre;
  double radius;
};

/// The face that two cells share.
struct Face {
  int a, b;  // among the balls, a < b
  double area;
};

/// Divides an ellipsoid with these semi-axes among balls: each point belongs to the ball from whose surface it is
/// nearest by d² - r², as in a power diagram [Aurenhammer 1987]. Returns all faces between two balls, by a and b, in
/// the ball's lengths. The ellipsoid bounds them as polygons of 96 corners do, to 0.1 %.
std::vector<Face> facesOf(const std::vector<Ball>& balls, const Point& middle, const std::array<double, 3>& axes);

/// Returns the pairs whose face is larger than 0.4 of the mean face: nuclei tell no more of small ones.
std::vector<std::pair<int, int>> touching(const std::vector<Ball>& balls, const Point& middle,
                                          const std::array<double, 3>& axes);

}  // namespace morula::tracks
