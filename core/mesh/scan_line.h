#pragma once
// Finds where a triangle meets a vertical line (x, y). Every line meets an even number of faces of a closed mesh. Each
// decision is taken per edge by half-open rules, from the edge's own numbers in an order that both of its faces share.
// A line through an edge or vertex then belongs to one of the faces around it, and crossings upwards and downwards
// balance exactly, whatever the rounding.
#include <utility>

#include "base/vec3.h"

namespace morula {

/// The piece of a triangle in the plane y = const.
struct Slice {
  double xLow = 0, xHigh = 0;  // lines with xLow <= x < xHigh meet the piece
  double zLow = 0, zHigh = 0;  // z at xLow and at xHigh
  int sign = 0;                // +1: the face looks up (a way up leaves the body here), −1: down

  bool meets(double x) const { return xLow <= x && x < xHigh; }
  double heightAt(double x) const { return zLow + (x - xLow) / (xHigh - xLow) * (zHigh - zLow); }
};

/// Returns false if the triangle does not reach the plane.
inline bool slice(const Point& a, const Point& b, const Point& c, double y, Slice& out) {
  const Point* corners[3] = {&a, &b, &c};
  double xUp = 0, zUp = 0, xDown = 0, zDown = 0;
  bool found = false;
  for (int k = 0; k < 3; ++k) {
    const Point *low = corners[k], *high = corners[k == 2 ? 0 : k + 1];
    if ((low->y <= y) == (high->y <= y)) continue;  // both on one side: true of one edge or all three
    const bool up = low->y <= y;
    if (!up) std::swap(low, high);
    const double t = (y - low->y) / (high->y - low->y);
    const double x = low->x + t * (high->x - low->x), z = low->z + t * (high->z - low->z);
    (up ? xUp : xDown) = x;
    (up ? zUp : zDown) = z;
    found = true;
  }
  if (!found) return false;
  // Counter-clockwise seen from above, the edge that goes up (towards +y) is on the right.
  if (xDown <= xUp) out = {xDown, xUp, zDown, zUp, +1};
  else out = {xUp, xDown, zUp, zDown, -1};
  return true;
}

}  // namespace morula
