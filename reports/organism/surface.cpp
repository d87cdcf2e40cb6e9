#include "organism/surface.h"

#include <algorithm>
#include <array>

#include "organism/shell_wall.h"

namespace morula {
namespace {

using Weights = std::array<double, 3>;

/// The split of a face into n² triangles: points on a lattice, and triangles between them, wound like the face.
struct Split {
  std::vector<Weights> points;
  std::vector<std::uint32_t> corners;
};

Split splitFace(int n) {
  Split split;
  const auto index = [n](int i, int j) { return std::uint32_t(i * (n + 1) - i * (i - 1) / 2 + j); };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      split.points.push_back({double(n - i - j) / n, double(i) / n, double(j) / n});
      if (i + j >= n) continue;
      split.corners.insert(split.corners.end(), {index(i, j), index(i + 1, j), index(i, j + 1)});
      if (i + j + 1 < n)
        split.corners.insert(split.corners.end(), {index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  return split;
}

int splitsFor(std::size_t faces) {
  constexpr std::size_t budget = 250'000;  // triangles that are drawn in a fraction of a second
  int n = 4;
  while (n > 1 && faces * std::size_t(n * n) > budget) --n;
  return n;
}

struct FaceInEye {
  std::array<Vector, 3> position, normal;

  Vector flat(const Weights& w) const { return position[0] * w[0] + position[1] * w[1] + position[2] * w[2]; }

  /// Returns the flat point moved halfway to the mean of its projections onto the corners' tangent planes. On a sphere
  /// of radius R the result is within O(edge⁴/R³) of it, because each plane stands off twice as far as the sphere.
  Vector curved(const Weights& w) const {
    constexpr double share = 0.5;
    const Vector p = flat(w);
    Vector result = p;
    for (int i = 0; i < 3; ++i) result -= normal[i] * (share * w[i] * dot(p - position[i], normal[i]));
    return result;
  }
};

std::uint16_t asUint16(double value) { return std::uint16_t(std::clamp(value, 0.0, 1.0) * 65535 + 0.5); }

/// Adds one cell to the surface.
class CellSurface {
 public:
  CellSurface(Surface& to, const OrganismPicture& picture, std::size_t number, const EyeAxes& axes, const Point& centre,
              const ShellWall& wall)
      : to_(to),
        cell_(picture.cells[number]),
        faces_(facesOf(picture, cell_)),
        wall_(wall.holds(cell_) ? &wall : nullptr) {
    normals_ = vertexNormals(cell_.vertices, faces_);
    positions_.reserve(cell_.vertices.size());
    for (const Point& vertex : cell_.vertices) positions_.push_back(axes.of(vertex - centre));
    for (Vector& normal : normals_) normal = axes.of(normal);
    vertex_.owner = std::uint32_t(number + 1);
    const double light[4] = {linearLight(cell_.colour.r), linearLight(cell_.colour.g), linearLight(cell_.colour.b),
                             cell_.opacity};
    std::transform(light, light + 4, vertex_.light, asUint16);
    vertex_.share = -1;
    if (!cell_.shares.empty()) to.mapped = true;
  }

  /// Adds split faces, each with vertices of its own.
  void addSplit(const Split& split) {
    for (const Face& face : faces_) {
      FaceInEye corners;
      for (int i = 0; i < 3; ++i) corners.position[i] = positions_[face[i]], corners.normal[i] = normals_[face[i]];
      for (const std::uint32_t corner : split.corners)
        to_.corners.push_back(std::uint32_t(to_.vertices.size()) + corner);
      for (const Weights& w : split.points) {
        const Vector n = corners.normal[0] * w[0] + corners.normal[1] * w[1] + corners.normal[2] * w[2];
        for (int i = 0; i < 3; ++i) vertex_.corner[i] = float(w[i]);
        if (!cell_.shares.empty())
          vertex_.share =
              float(cell_.shares[face[0]] * w[0] + cell_.shares[face[1]] * w[1] + cell_.shares[face[2]] * w[2]);
        add(corners.curved(w), n);
      }
    }
  }

  /// Adds unsplit faces, which share vertices.
  void addShared() {
    const auto first = std::uint32_t(to_.vertices.size());
    for (const Face& face : faces_)
      for (const auto corner : face) to_.corners.push_back(first + std::uint32_t(corner));
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      if (!cell_.shares.empty()) vertex_.share = float(cell_.shares[i]);
      add(positions_[i], normals_[i]);
    }
  }

 private:
  void add(const Vector& place, const Vector& n) {
    const Vector p = wall_ ? wall_->inside(place) : place;
    const double values[6] = {p.x, p.y, p.z, n.x, n.y, n.z};
    for (int i = 0; i < 3; ++i) vertex_.position[i] = float(values[i]), vertex_.normal[i] = float(values[3 + i]);
    to_.vertices.push_back(vertex_);
  }

  Surface& to_;
  const CellShape& cell_;
  const std::vector<Face>& faces_;
  const ShellWall* wall_;  // null: does not hold the cell
  std::vector<Vector> positions_, normals_;
  SurfaceVertex vertex_{};
};

}  // namespace

std::vector<Vector> vertexNormals(const std::vector<Point>& vertices, const std::vector<Face>& faces) {
  std::vector<Vector> normals(vertices.size());
  for (const Face& f : faces) {
    for (int i = 0; i < 3; ++i) {
      const Vector one = vertices[f[(i + 1) % 3]] - vertices[f[i]], other = vertices[f[(i + 2) % 3]] - vertices[f[i]];
      const double weight = dot(one, one) * dot(other, other);
      if (weight > 0) normals[f[i]] += cross(one, other) / weight;
    }
  }
  for (Vector& normal : normals) {
    const double length = norm(normal);
    normal = length > 0 ? normal / length : Vector{0, 0, 1};
  }
  return normals;
}

Surface makeSurface(const OrganismPicture& picture, const EyeAxes& axes, const Framing& framing, bool withEdges) {
  std::size_t faces = 0;
  for (const CellShape& cell : picture.cells) faces += facesOf(picture, cell).size();
  const int splits = splitsFor(faces);
  const Split split = splitFace(splits);
  const bool shares = splits == 1 && !withEdges;
  const ShellWall wall(picture, axes, framing);
  Surface surface;
  if (!shares) surface.vertices.reserve(faces * split.points.size());
  surface.corners.reserve(faces * split.corners.size());
  for (const bool solid : {true, false}) {
    for (std::size_t i = 0; i < picture.cells.size(); ++i) {
      const double opacity = picture.cells[i].opacity;
      if (!(opacity > 0 && (opacity >= 1) == solid)) continue;
      const std::size_t first = surface.corners.size();
      CellSurface cell(surface, picture, i, axes, framing.centre, wall);
      if (shares) cell.addShared();
      else cell.addSplit(split);
      surface.cells.push_back({i, first, surface.corners.size() - first});
    }
    if (solid) surface.solid = surface.corners.size();
  }
  return surface;
}

}  // namespace morula
