#include "organism/camera.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace morula {
namespace {

constexpr double halfAngle = 0.19;  // tangent; about 21 degrees over the smaller side of the picture
constexpr double margin = 1.06;     // room between the outermost points and the picture's edge

}  // namespace

EyeAxes eyeAxes(const Camera& camera) {
  const double length = norm(camera.towardsEye);
  if (!(length > 0) || !std::isfinite(length))
    throw InputError("the camera's direction has no length; give it any other than (0, 0, 0)");
  const Vector z = camera.towardsEye / length;
  const Vector right = cross(camera.up, z);
  const double width = norm(right);
  if (!(width > 1e-9 * norm(camera.up)) || !std::isfinite(width))
    throw InputError("the camera's up is parallel to its direction or has no length; choose another");
  const Vector x = right / width;
  return {x, cross(z, x), z};
}

Aperture apertureOf(int width, int height) {
  const double smaller = std::min(width, height);
  return {halfAngle * width / smaller, halfAngle * height / smaller};
}

void FramingFinder::seeFirst(const Point& point) {
  const Vector p = axes_.of(point);
  if (!any_) low_ = high_ = p;
  any_ = true;
  low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
  high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
}

void FramingFinder::seeAgain(const Point& point) {
  // A point at (x, y, z) from the middle is seen if |x| <= aperture · (distance − z).
  const Vector p = axes_.of(point) - middle();
  distance_ =
      std::max({distance_, std::abs(p.x) * margin / aperture_.x + p.z, std::abs(p.y) * margin / aperture_.y + p.z});
}

Framing FramingFinder::framing() const {
  if (!any_) return {};
  const Vector m = middle();
  return {axes_.x * m.x + axes_.y * m.y + axes_.z * m.z, distance_ > 0 ? distance_ : 1};
}

Framing frame(const std::vector<Point>& points, const EyeAxes& axes, const Aperture& aperture) {
  FramingFinder finder(axes, aperture);
  for (const Point& point : points) finder.seeFirst(point);
  for (const Point& point : points) finder.seeAgain(point);
  return finder.framing();
}

double distanceFor(const std::vector<Point>& points, const Point& centre, const EyeAxes& axes,
                   const Aperture& aperture) {
  double distance = 0;
  for (const Point& point : points) {
    const Vector p = axes.of(point - centre);
    distance =
        std::max({distance, std::abs(p.x) * margin / aperture.x + p.z, std::abs(p.y) * margin / aperture.y + p.z});
  }
  return distance > 0 ? distance : 1;
}

std::array<float, 16> projection(const Aperture& aperture, double distance, double nearClip, double farClip) {
  const double depth = farClip - nearClip;
  std::array<double, 16> m{};
  m[0] = 1 / aperture.x;
  m[5] = 1 / aperture.y;
  // The depth d = distance − z from the eye becomes (far + near)/depth − 2·far·near/(depth·d), in [−1, 1].
  m[10] = -(farClip + nearClip) / depth;
  m[11] = -1;
  m[14] = -2 * farClip * nearClip / depth + distance * (farClip + nearClip) / depth;
  m[15] = distance;
  std::array<float, 16> result;
  std::transform(m.begin(), m.end(), result.begin(), [](double value) { return float(value); });
  return result;
}

}  // namespace morula
