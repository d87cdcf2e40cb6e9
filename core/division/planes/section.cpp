#include "division/planes/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "division/principal_axis.h"

namespace morula {
namespace {

/// Directions over half a sphere, which hold one of each two opposite ones, and the neighbours of each.
struct Directions {
  std::vector<Vector> all;
  std::vector<std::vector<int>> next;
};

Directions makeDirections() {
  const Mesh sphere = makeIcosphere(3);  // 642 directions, 8° apart
  Directions d;
  std::vector<int> place(sphere.vertices.size(), -1);
  for (std::size_t v = 0; v < sphere.vertices.size(); ++v)
    if (towardsOwnSide(sphere.vertices[v]) == sphere.vertices[v]) {
      place[v] = static_cast<int>(d.all.size());
      d.all.push_back(sphere.vertices[v] / norm(sphere.vertices[v]));
    }
  // Directions of the other half take the place of their opposite, the nearest: the icosphere has mirror images.
  for (std::size_t v = 0; v < sphere.vertices.size(); ++v) {
    if (place[v] >= 0) continue;
    const auto nearer = [&](const Vector& a, const Vector& b) {
      return dot(a, sphere.vertices[v]) < dot(b, sphere.vertices[v]);
    };
    place[v] = static_cast<int>(std::ranges::min_element(d.all, nearer) - d.all.begin());
  }
  d.next.resize(d.all.size());
  for (const Face& face : sphere.faces)
    for (int k = 0; k < 3; ++k) d.next[place[face[k]]].push_back(place[face[(k + 1) % 3]]);
  return d;
}

/// Goes downhill on the sphere of directions, to the best of eight places around and, where none is better, in steps
/// half as long.
Vector refine(const Mesh& mesh, const Point& point, Vector normal, double area) {
  constexpr std::array<std::array<double, 2>, 8> around{
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {0.7, 0.7}, {0.7, -0.7}, {-0.7, 0.7}, {-0.7, -0.7}}};
  for (double step = 0.07; step > 1e-5;) {
    const Vector side = std::abs(normal.x) < 0.6 ? Vector{1, 0, 0} : Vector{0, 1, 0};
    Vector u = cross(normal, side);
    u = u / norm(u);
    const Vector v = cross(normal, u);
    Vector best = normal;
    double least = area;
    for (const auto& [a, b] : around) {
      Vector other = normal + step * (a * u + b * v);
      other = other / norm(other);
      if (const double there = sectionArea(mesh, point, other); there < least) least = there, best = other;
    }
    if (least < area) normal = best, area = least;
    else step /= 2;
  }
  return normal;
}

}  // namespace

// Each face that the plane crosses adds the segment between its two crossings, as an oriented side of the
// section: ½ Σ (p − o) × (q − o) · n, with the same turn on all faces, for they are oriented alike.
double sectionArea(const Mesh& mesh, const Point& point, const Vector& normal) {
  double twice = 0;
  const auto heightOf = [&](std::uint32_t v) { return dot(mesh.vertices[v] - point, normal); };
  for (const Face& face : mesh.faces) {
    const std::array<double, 3> h{heightOf(face[0]), heightOf(face[1]), heightOf(face[2])};
    const bool above[3] = {h[0] > 0, h[1] > 0, h[2] > 0};
    if (above[0] == above[1] && above[1] == above[2]) continue;
    Vector up, down;  // where the face's rim, followed around, comes through the plane
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      if (above[k] == above[l]) continue;
      const Vector from = mesh.vertices[face[k]] - point, to = mesh.vertices[face[l]] - point;
      (above[l] ? up : down) = from + (h[k] / (h[k] - h[l])) * (to - from);
    }
    twice += dot(cross(up, down), normal);
  }
  return std::abs(twice) / 2;
}

Vector smallestSection(const Mesh& mesh, const Point& point) {
  static const Directions directions = makeDirections();
  const auto& [all, next] = directions;
  std::vector<double> area(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) area[i] = sectionArea(mesh, point, all[i]);
  const double least = *std::ranges::min_element(area);

  std::vector<std::pair<Vector, double>> minima;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto isLower = [&](int other) { return area[other] < area[i]; };
    if (area[i] > 1.02 * least || std::ranges::any_of(next[i], isLower)) continue;
    const Vector normal = towardsOwnSide(refine(mesh, point, all[i], area[i]));
    minima.emplace_back(normal, sectionArea(mesh, point, normal));
  }
  const double smallest = std::ranges::min_element(minima, {}, &std::pair<Vector, double>::second)->second;
  std::erase_if(minima, [&](const auto& one) { return one.second > (1 + 1e-6) * smallest; });
  return std::ranges::max_element(minima, {}, [](const auto& one) { return dot(one.first, ownSide); })->first;
}

}  // namespace morula
