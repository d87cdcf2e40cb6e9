#pragma once
// The camera: the place of the eye, and the map from space to the picture, a gentle perspective, so that a compact
// organism looks solid without being bent. It is placed by name or by angles, and goes once around.
#include <array>
#include <string_view>
#include <vector>

#include "base/vec3.h"
#include "organism/organism.h"

namespace morula {

/// The eye's own axes; x to the right, y up, z from the scene to the eye. Right-handed, unit length.
struct EyeAxes {
  Vector x, y, z;
  Vector of(const Vector& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
};

/// Throws InputError if the directions have no length or are parallel.
EyeAxes eyeAxes(const Camera& camera);

/// Tangents of half the angles that the picture's width and height are seen under, from the eye: the smaller
/// one is 0.19, the larger follows from the sides.
struct Aperture {
  double x, y;
};
Aperture apertureOf(int width, int height);

/// Finds the nearest framing of points that are too many to be kept: all are seen twice, in any order.
class FramingFinder {
 public:
  FramingFinder(const EyeAxes& axes, const Aperture& aperture) : axes_(axes), aperture_(aperture) {}
  void seeFirst(const Point& point);  // all points, then
  void seeAgain(const Point& point);  // all points once more
  Framing framing() const;            // as frame() of these points

 private:
  Vector middle() const { return (low_ + high_) * 0.5; }

  EyeAxes axes_;
  Aperture aperture_;
  bool any_ = false;
  Vector low_, high_;
  double distance_ = 0;
};

/// The nearest framing from which all points are seen, with a margin, the box around them in the middle.
/// Points at one place only (or none) give distance 1.
Framing frame(const std::vector<Point>& points, const EyeAxes& axes, const Aperture& aperture);

/// The least distance from which all points are seen, with the same margin, when the eye looks at `centre`.
/// Points at `centre` only (or none) give 1.
double distanceFor(const std::vector<Point>& points, const Point& centre, const EyeAxes& axes,
                   const Aperture& aperture);

/// Projection of eye coordinates relative to the framing's centre (so x right, y up, z to the eye, the eye itself at z
/// = distance), column by column as OpenGL wants it. Depths nearClip to farClip from the eye are kept.
std::array<float, 16> projection(const Aperture& aperture, double distance, double nearClip, double farClip);

/// The angles of a named view: front, back, left, right, top, bottom, iso. Throws InputError with the names for any
/// other, and "AZ,EL" is read as two numbers [degrees], the elevation -90 to 90.
Camera parseView(std::string_view text);

/// `count` > 0 cameras around the picture, turned about the z axis by equal angles, the first as its own: with one
/// framing in which it is whole from all of them.
std::vector<Camera> turntable(const OrganismPicture& picture, int count);

}  // namespace morula
