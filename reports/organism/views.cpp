#include "organism/views.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "base/error.h"

namespace morula {
namespace {

struct View {
  std::string_view name;
  double azimuth, elevation;  // [degree]
};

/// asin(1/√3): the eye stands on the diagonal of a cube.
constexpr double cubeDiagonal = 35.264389682754654;
constexpr std::array views{View{"front", 0, 0},          View{"back", 180, 0}, View{"left", -90, 0},
                           View{"right", 90, 0},         View{"top", 0, 90},   View{"bottom", 0, -90},
                           View{"iso", 45, cubeDiagonal}};

/// Sine of whole quarter turns is exact, so that axes lie along rows and columns of pixels.
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

Vector turned(const Vector& v, double degrees) {
  const double c = cosine(degrees), s = sine(degrees);
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

}  // namespace

Camera cameraAt(double azimuth, double elevation) {
  const double sa = sine(azimuth), ca = cosine(azimuth), se = sine(elevation), ce = cosine(elevation);
  // `up` is what the direction changes by with the elevation, so it is never parallel to it.
  return {.towardsEye = {sa * ce, -ca * ce, se}, .up = {-sa * se, ca * se, ce}, .framing = std::nullopt};
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
  throw InputError("'" + std::string(text) + "' is no view; needs " + viewNames() +
                   ", or azimuth and elevation in degrees such as 30,20 (-360 to 360, -90 to 90)");
}

const char* viewNames() { return "front, back, left, right, top, bottom, iso"; }

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
