#include "organism/camera.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "base/error.h"

namespace morula {
namespace {

constexpr double halfAngle = 0.19;  // tangent; about 21 degrees over the smaller side of the picture
constexpr double margin = 1.06;     // room between the outermost points and the picture's edge

struct View {
  std::string_view name;
  double azimuth, elevation;  // [degree]
};

/// asin(1/√3): the elevation of a cube's diagonal.
constexpr double cubeDiagonal = 35.264389682754654;
constexpr std::array views{View{"front", 0, 0},          View{"back", 180, 0}, View{"left", -90, 0},
                           View{"right", 90, 0},         View{"top", 0, 90},   View{"bottom", 0, -90},
                           View{"iso", 45, cubeDiagonal}};

/// Returns the sine, exact for whole quarter turns, so that axes lie along rows and columns of pixels.
double sine(double degrees) {
  const double turn = std::fmod(degrees, 360.0);
  if (std::fmod(turn, 90.0) == 0) {
    const int quarter = (int(turn / 90) % 4 + 4) % 4;
    return quarter == 1 ? 1 : quarter == 3 ? -1 : 0;
  }
  return std::sin(turn * std::numbers::pi / 180);
}
double cosine(double degrees) { return sine(degrees + 90); }

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Returns the camera at this azimuth and elevation [degrees]. (0, 0) looks along +y with z up, from the front. The
/// azimuth turns the eye towards +x, to the right side; the elevation lifts it towards +z.
Camera cameraAt(double azimuth, double elevation) {
  const double sa = sine(azimuth), ca = cosine(azimuth), se = sine(elevation), ce = cosine(elevation);
  // `up` is the derivative of the direction by the elevation, so the two are perpendicular.
  return {.towardsEye = {sa * ce, -ca * ce, se}, .up = {-sa * se, ca * se, ce}, .framing = std::nullopt};
}

Vector turned(const Vector& v, double degrees) {
  const double c = cosine(degrees), s = sine(degrees);
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

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
  // A point at (x, y, z) from the middle is visible if |x| <= aperture · (distance − z).
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

Camera parseView(std::string_view text) {
  for (const View& view : views)
    if (view.name == text) return cameraAt(view.azimuth, view.elevation);
  const auto comma = text.find(',');
  if (comma != text.npos) {
    const auto azimuth = number(text.substr(0, comma)), elevation = number(text.substr(comma + 1));
    if (azimuth && elevation && std::abs(*azimuth) <= 360 && std::abs(*elevation) <= 90)
      return cameraAt(*azimuth, *elevation);
  }
  throw InputError("'" + std::string(text) + "' is no view; needs front, back, left, right, top, bottom, iso, " +
                   "or azimuth and elevation in degrees such as 30,20 (-360 to 360, -90 to 90)");
}

std::vector<Camera> turntable(const OrganismPicture& picture, int count) {
  std::vector<Camera> cameras(std::size_t(count), picture.camera);
  for (int i = 0; i < count; ++i) {
    cameras[i].towardsEye = turned(cameras[i].towardsEye, 360.0 * i / count);
    cameras[i].up = turned(cameras[i].up, 360.0 * i / count);
  }
  const Framing framing = commonFraming(picture, cameras);
  for (Camera& camera : cameras) camera.framing = framing;
  return cameras;
}

}  // namespace morula
