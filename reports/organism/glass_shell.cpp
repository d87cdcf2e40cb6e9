#include <algorithm>
#include <cmath>

#include "organism/drawn_samples.h"

namespace morula {
namespace {

Vector ratio(const Vector& a, const Vector& b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
Vector normalise(const Vector& a) { return a / norm(a); }
double mix(double a, double b, double share) { return a + (b - a) * share; }

}  // namespace

void coverWithGlass(const Samples& samples, const GlassShell& shell, int y, std::vector<Seen>& row) {
  const auto& [semiAxes, axes, centre] = shell;
  // The eye's axes and the ray steps are in the space in which the shell is the unit sphere.
  const Vector across = ratio(axes.x, semiAxes), upward = ratio(axes.y, semiAxes), towards = ratio(axes.z, semiAxes);
  const double distance = samples.eyeDistance, middle = 0.5 * (samples.along - 1);
  const Vector eye = distance * towards + ratio(centre, semiAxes), lamp = normalise({-0.55, 0.75, 0.70});
  // The changes of a ray from pixel to pixel.
  const Vector right = 2 * samples.apertureX * distance / samples.width * across,
               up = 2 * samples.apertureY * distance / samples.height * upward;
  const double c = dot(eye, eye) - 1, rayY = samples.rayY(float(y * samples.along + middle)) * distance;
  for (int x = 0; x < samples.width; ++x) {
    // The ray through the pixel's middle meets the sphere at t with a·t² + 2b·t + c = 0.
    const double rayX = samples.rayX(float(x * samples.along + middle)) * distance;
    const Vector ray = rayX * across + rayY * upward - distance * towards;
    const double a = dot(ray, ray), b = dot(eye, ray), discriminant = b * b - a * c;
    // The edge is softened by the change of the discriminant from pixel to pixel.
    const double slopeX = 2 * (b * dot(eye, right) - c * dot(ray, right)),
                 slopeY = 2 * (b * dot(eye, up) - c * dot(ray, up)),
                 slope = std::sqrt(slopeX * slopeX + slopeY * slopeY);
    if (discriminant <= -0.5 * slope) continue;
    const double edge = std::min(0.5 + discriminant / std::max(1e-12, slope), 1.0),
                 t = (-b - std::sqrt(std::max(discriminant, 0.0))) / a;
    if (t <= 0) continue;
    const double height = samples.heights[samples.pixelAt(x, y)], away = 1 - height / distance;
    const Vector shown = away * rayX * across + away * rayY * upward + height * towards + ratio(centre, semiAxes);
    if (away < t && dot(shown, shown) > 1.02) continue;  // a cell that sticks out of the shell
    const Vector n = normalise(axes.of(ratio(eye + t * ray, semiAxes))), v = normalise({-rayX, -rayY, distance});
    const double slant = 1 - std::max(0.0, dot(n, v)), s2 = slant * slant,
                 cover = 0.02 + 0.12 * s2 + 0.46 * s2 * s2 * s2;
    double shine = std::max(0.0, dot(n, normalise(lamp + v)));
    for (int i = 0; i < 6; ++i) shine *= shine;  // to the 64th
    constexpr double straight[3] = {0.66, 0.74, 0.82}, rim[3] = {0.30, 0.38, 0.47};
    Seen& pixel = row[x];
    for (int i = 0; i < 3; ++i) {
      const double glass = mix(straight[i], rim[i], s2), behind = pixel.light[i];
      pixel.light[i] = float(std::min(mix(behind, mix(behind, glass, cover) + 0.14 * shine, edge), 1.0));
    }
    pixel.opacity = float(mix(pixel.opacity, std::min(1.0, mix(pixel.opacity, 1, cover) + 0.14 * shine), edge));
  }
}

}  // namespace morula
