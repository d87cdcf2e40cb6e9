#include "mesh/distance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/mesh_measures.h"

namespace morula {

namespace {

Vector nearestOnSegment(const Point& p, const Point& a, const Point& b) {
  const Vector d = b - a;
  const double length = dot(d, d);
  const double share = length > 0 ? std::clamp(dot(p - a, d) / length, 0.0, 1.0) : 0;
  return a + share * d;
}

/// Returns the squared distance of p: from its foot if the triangle has it, else from the nearest side p lies beyond.
double squaredDistance(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Vector n = cross(b - a, c - a);
  const double area = dot(n, n);
  double least = INFINITY;
  for (const auto& [u, v] : {std::pair{a, b}, {b, c}, {c, a}}) {
    if (area > 0 && dot(cross(v - u, p - u), n) >= 0) continue;
    const Vector off = p - nearestOnSegment(p, u, v);
    least = std::min(least, dot(off, off));
  }
  const double height = dot(p - a, n);
  return least < INFINITY ? least : height * height / area;
}

/// A face with the ball around it, which rules out most faces quickly.
struct Patch {
  Point a, b, c, centre;
  double radius;
};

std::vector<Patch> patchesOf(const Mesh& mesh) {
  std::vector<Patch> patches;  // sorted by their centres' x
  for (const Face& f : mesh.faces) {
    Patch p{mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]], {}, 0};
    p.centre = (p.a + p.b + p.c) / 3.0;
    p.radius = std::max({norm(p.a - p.centre), norm(p.b - p.centre), norm(p.c - p.centre)});
    patches.push_back(p);
  }
  std::sort(patches.begin(), patches.end(), [](const Patch& a, const Patch& b) { return a.centre.x < b.centre.x; });
  return patches;
}

/// Returns squared distances from the vertices of `from` to the surface of `to`.
std::vector<double> squaredDistances(const Mesh& from, const Mesh& to) {
  const std::vector<Patch> patches = patchesOf(to);
  double largest = 0;
  for (const Patch& patch : patches) largest = std::max(largest, patch.radius);
  std::vector<double> squares;
  for (std::size_t v = 0; v < from.vertices.size(); ++v) {
    const Point& p = from.vertices[v];
    // Begins with an upper bound: the vertex of the same number, which is near if the meshes are alike.
    const Vector guess = p - to.vertices[std::min(v, to.vertices.size() - 1)];
    double least = dot(guess, guess), reach = std::sqrt(least);
    const auto tryPatch = [&](const Patch& patch) {
      const Vector away = p - patch.centre;
      const double far = reach + patch.radius;
      if (dot(away, away) > far * far) return;
      const double squared = squaredDistance(p, patch.a, patch.b, patch.c);
      if (squared < least) least = squared, reach = std::sqrt(squared);
    };
    // Searches outwards on both sides of the vertex's x, as far as a patch could still be nearer than the nearest.
    const auto middle =
        std::lower_bound(patches.begin(), patches.end(), p.x, [](const Patch& q, double x) { return q.centre.x < x; });
    for (auto up = middle; up != patches.end() && up->centre.x - p.x <= reach + largest; ++up) tryPatch(*up);
    for (auto down = middle; down != patches.begin() && p.x - std::prev(down)->centre.x <= reach + largest; --down)
      tryPatch(*std::prev(down));
    squares.push_back(least);
  }
  return squares;
}

/// Returns the closed surface's winding number around a point, 0 outside: how often a ray from the point leaves the
/// surface, minus how often it enters. The ray lies in no plane of symmetry of our meshes, so it runs along no edge.
int windingAround(const Point& p, const Mesh& mesh) {
  const Vector ray{0.8017837, 0.2672613, 0.5345225};
  int winding = 0;
  for (const Face& f : mesh.faces) {
    const Vector a = mesh.vertices[f[0]] - p, b = mesh.vertices[f[1]] - p, c = mesh.vertices[f[2]] - p;
    const double ab = dot(cross(a, b), ray), bc = dot(cross(b, c), ray), ca = dot(cross(c, a), ray);
    const bool outwards = ab > 0 && bc > 0 && ca > 0, inwards = ab < 0 && bc < 0 && ca < 0;
    if ((outwards || inwards) && dot(cross(b - a, c - a), a) * (outwards ? 1 : -1) > 0) winding += outwards ? 1 : -1;
  }
  return winding;
}

double sumOfSquares(const Mesh& from, const Mesh& to) {
  double sum = 0;
  for (const double square : squaredDistances(from, to)) sum += square;
  return sum;
}

}  // namespace

std::vector<double> measureDistances(const Mesh& from, const Mesh& to) {
  std::vector<double> distances = squaredDistances(from, to);
  for (double& d : distances) d = std::sqrt(d);
  return distances;
}

double measureDepth(const Mesh& a, const Mesh& b) {
  const Box box = measureBox(b.vertices);
  Mesh inside;
  for (const Point& p : a.vertices)
    if (p.x > box.low.x && p.y > box.low.y && p.z > box.low.z && p.x < box.high.x && p.y < box.high.y &&
        p.z < box.high.z && windingAround(p, b) != 0)
      inside.vertices.push_back(p);
  const std::vector<double> depths = measureDistances(inside, b);
  return depths.empty() ? 0 : std::ranges::max(depths);
}

double measureSurfaceDistance(const Mesh& a, const Mesh& b) {
  const double count = static_cast<double>(a.vertices.size() + b.vertices.size());
  return std::sqrt((sumOfSquares(a, b) + sumOfSquares(b, a)) / count);
}

}  // namespace morula
