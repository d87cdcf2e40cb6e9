#pragma once
// The camera: the position of the eye, and a weak perspective, so that a compact organism looks solid but undistorted.
// A camera is given by a view's name or by angles, and can go once around the organism.
#include <array>
#include <string_view>
#include <vector>

#include "base/vec3.h"
#include "organism/organism.h"

namespace morula {

/// The eye's axes: x to the right, y up, z from the scene to the eye. The axes are right-handed and have unit length.
struct EyeAxes {
  Vector x, y, z;
  Vector of(const Vector& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
};

/// Returns the axes of a camera. Throws InputError if its directions have no length or are parallel.
EyeAxes eyeAxes(const Camera& camera);

/// Tangents of half the angles of view of the picture's width and height. The smaller one is 0.19; the larger follows
/// from the sides.
struct Aperture {
  double x, y;
};
Aperture apertureOf(int width, int height);

/// Finds the nearest framing of more points than fit in memory. All points are passed twice, in any order.
class FramingFinder {
 public:
  FramingFinder(const EyeAxes& axes, const Aperture& aperture) : axes_(axes), aperture_(aperture) {}
  void seeFirst(const Point& point);  // takes each point, before any call of seeAgain
  void seeAgain(const Point& point);  // takes each point a second time
  Framing framing() const;            // the result of frame() for these points

 private:
  Vector middle() const { return (low_ + high_) * 0.5; }

  EyeAxes axes_;
  Aperture aperture_;
  bool any_ = false;
  Vector low_, high_;
  double distance_ = 0;
};

/// Returns the nearest framing that contains all points, with a margin and with their box in the middle. Points that
/// coincide (or none) give distance 1.
Framing frame(const std::vector<Point>& points, const EyeAxes& axes, const Aperture& aperture);

/// Returns the min distance from which an eye that looks at `centre` sees all points, with the margin of frame().
/// Points at `centre` only (or none) give 1.
double distanceFor(const std::vector<Point>& points, const Point& centre, const EyeAxes& axes,
                   const Aperture& aperture);

/// Returns the projection of eye coordinates relative to the framing's centre: x right, y up, z to the eye, which
/// stands at z = distance. The matrix is stored by columns, as in OpenGL. Depths nearClip to farClip from the eye are
/// visible.
std::array<float, 16> projection(const Aperture& aperture, double distance, double nearClip, double farClip);

/// Returns the camera of a named view (front, back, left, right, top, bottom, iso) or of "AZ,EL" [degrees], EL from -90
/// to 90. Throws InputError with the names for any other text.
Camera parseView(std::string_view text);

/// Returns `count` > 0 cameras around the picture, starting with its own and turned about the z axis by equal angles.
/// One framing holds the picture from all of them.
std::vector<Camera> turntable(const OrganismPicture& picture, int count);

}  // namespace morula
