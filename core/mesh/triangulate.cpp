#include "mesh/triangulate.h"

#include <algorithm>
#include <cmath>

namespace morula {
namespace {

/// Shares of the polygon's extent, and of its square for areas, below which rounding decides the sign.
constexpr double rounding = 1e-12;

struct Flat {
  double x, y;
};

double twiceArea(const Flat& a, const Flat& b, const Flat& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Newell's normal: Σ xᵢ × xᵢ₊₁, twice the area, of a polygon that need not be flat.
Vector normalOf(const std::vector<Point>& corners) {
  Vector sum{0, 0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  return sum;
}

bool fanCovers(const std::vector<Point>& corners, const Vector& normal) {
  const double least = rounding * dot(normal, normal);
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    if (!(dot(cross(corners[k] - corners[0], corners[k + 1] - corners[0]), normal) > least)) return false;
  return true;
}

/// Returns the corners without the coordinate along which the normal is longest, turned so that the polygon is
/// counter-clockwise.
std::vector<Flat> flatten(const std::vector<Point>& corners, const Vector& normal) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  std::vector<Flat> flat;
  for (const Point& p : corners) {
    Flat f = x >= y && x >= z ? Flat{p.y, p.z} : y >= z ? Flat{p.z, p.x} : Flat{p.x, p.y};
    const double along = x >= y && x >= z ? normal.x : y >= z ? normal.y : normal.z;
    if (along < 0) std::swap(f.x, f.y);
    flat.push_back(f);
  }
  return flat;
}

class Ears {
 public:
  explicit Ears(std::vector<Flat> corners) : at_(std::move(corners)) {
    double low = INFINITY, high = -INFINITY;
    for (const Flat& p : at_) {
      low = std::min({low, p.x, p.y});
      high = std::max({high, p.x, p.y});
      left_.push_back(static_cast<int>(left_.size()));
    }
    least_ = rounding * (high - low) * (high - low);
  }

  /// Returns false if two sides cross that are not neighbours.
  bool isSimple() const {
    const int n = static_cast<int>(at_.size());
    for (int i = 0; i < n; ++i)
      for (int j = i + 2; j < n; ++j)
        if ((j + 1) % n != i && cross(at_[i], at_[i + 1], at_[j], at_[(j + 1) % n])) return false;
    return true;
  }

  /// Returns no triangles if at some step no corner is an ear.
  std::vector<std::array<int, 3>> cut() {
    std::vector<std::array<int, 3>> triangles;
    while (left_.size() > 3) {
      const int ear = bestEar();
      if (ear < 0) return {};
      triangles.push_back(triangleAt(ear));
      left_.erase(left_.begin() + ear);
    }
    if (!(areaAt(1) > least_)) return {};
    triangles.push_back(triangleAt(1));
    return triangles;
  }

 private:
  bool cross(const Flat& a, const Flat& b, const Flat& c, const Flat& d) const {
    const double abc = twiceArea(a, b, c), abd = twiceArea(a, b, d), cda = twiceArea(c, d, a), cdb = twiceArea(c, d, b);
    const auto apart = [&](double one, double other) {
      return (one > least_ && other < -least_) || (one < -least_ && other > least_);
    };
    return apart(abc, abd) && apart(cda, cdb);
  }

  std::array<int, 3> triangleAt(int i) const {
    const int n = static_cast<int>(left_.size());
    return {left_[(i + n - 1) % n], left_[i], left_[(i + 1) % n]};
  }
  double areaAt(int i) const {
    const auto [a, b, c] = triangleAt(i);
    return twiceArea(at_[a], at_[b], at_[c]);
  }

  /// Returns the triangle's smallest height over its longest side, or 0 if the corner does not turn left.
  double qualityAt(int i) const {
    const double area = areaAt(i);
    if (!(area > least_)) return 0;
    const auto [a, b, c] = triangleAt(i);
    double longest = 0;
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const double x = at_[q].x - at_[p].x, y = at_[q].y - at_[p].y;
      longest = std::max(longest, x * x + y * y);
    }
    return area / longest;
  }

  /// True if no other corner that is left lies in the triangle at `i` or on its sides.
  bool isFree(int i) const {
    const auto [a, b, c] = triangleAt(i);
    for (const int other : left_) {
      if (other == a || other == b || other == c) continue;
      const Flat& p = at_[other];
      if (twiceArea(at_[a], at_[b], p) >= -least_ && twiceArea(at_[b], at_[c], p) >= -least_ &&
          twiceArea(at_[c], at_[a], p) >= -least_)
        return false;
    }
    return true;
  }

  int bestEar() const {
    std::vector<std::pair<double, int>> candidates;
    for (int i = 0; i < static_cast<int>(left_.size()); ++i)
      if (const double quality = qualityAt(i); quality > 0) candidates.push_back({-quality, i});
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [quality, i] : candidates)
      if (isFree(i)) return i;
    return -1;
  }

  std::vector<Flat> at_;   // [corner]
  std::vector<int> left_;  // corners that have not been cut off
  double least_;           // twice the smallest area that is more than rounding
};

}  // namespace

Triangulation triangulate(const std::vector<Point>& corners) {
  Triangulation result;
  if (corners.size() == 3) {  // the mesh's own check reports a flat triangle
    result.triangles = {{0, 1, 2}};
    return result;
  }
  const Vector normal = normalOf(corners);
  if (!(dot(normal, normal) > 0)) {
    result.wrong = "this face has no area; its corners lie on one line";
    return result;
  }
  if (fanCovers(corners, normal)) {
    for (int k = 1; k + 1 < static_cast<int>(corners.size()); ++k) result.triangles.push_back({0, k, k + 1});
    return result;
  }
  Ears ears(flatten(corners, normal));
  if (ears.isSimple()) result.triangles = ears.cut();
  if (result.triangles.empty())
    result.wrong = "the outline of this face crosses or touches itself; split it into triangles";
  return result;
}

}  // namespace morula
