#include "organism/surface.h"

#include <algorithm>
#include <array>

namespace morula {
namespace {

using Weights = std::array<double, 3>;

/// How a face is split into n² triangles: points on a lattice, and the triangles between them, wound like the
/// face.
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
  constexpr std::size_t budget = 250'000;  // triangles: what is drawn in a fraction of a second
  int n = 4;
  while (n > 1 && faces * std::size_t(n * n) > budget) --n;
  return n;
}

struct FaceInEye {
  std::array<Vector, 3> position, normal;

  Vector flat(const Weights& w) const { return position[0] * w[0] + position[1] * w[1] + position[2] * w[2]; }

  /// The flat point moved halfway to the mean of its projections onto the corners' tangent planes: on a
  /// sphere of radius R that lies within O(edge⁴/R³) of it, because each plane stands off twice as far as the
  /// sphere.
  Vector curved(const Weights& w) const {
    constexpr double share = 0.5;
    const Vector p = flat(w);
    Vector result = p;
    for (int i = 0; i < 3; ++i) result -= normal[i] * (share * w[i] * dot(p - position[i], normal[i]));
    return result;
  }
};

std::uint16_t asUint16(double value) { return std::uint16_t(std::clamp(value, 0.0, 1.0) * 65535 + 0.5); }

Vector lightOf(Colour c) { return {linearLight(c.r), linearLight(c.g), linearLight(c.b)}; }

void addCell(Surface& to, const OrganismPicture& picture, std::size_t number, const EyeAxes& axes,
             const Point& centre, const Split& split) {
  const CellShape& cell = picture.cells[number];
  std::vector<Vector> normals = vertexNormals(cell.vertices, facesOf(picture, cell));
  std::vector<Vector> positions;
  positions.reserve(cell.vertices.size());
  for (const Point& vertex : cell.vertices) positions.push_back(axes.of(vertex - centre));
  for (Vector& normal : normals) normal = axes.of(normal);
  SurfaceVertex vertex{};
  vertex.owner = std::uint32_t(number + 1);
  const auto setLight = [&](const Vector& l) {
    const double light[4] = {l.x, l.y, l.z, cell.opacity};
    std::transform(light, light + 4, vertex.light, asUint16);
  };
  setLight(lightOf(cell.colour));
  std::vector<Vector> lights;
  for (const Colour& colour : cell.colours) lights.push_back(lightOf(colour));
  for (const Face& face : facesOf(picture, cell)) {
    FaceInEye corners;
    for (int i = 0; i < 3; ++i)
      corners.position[i] = positions[face[i]], corners.normal[i] = normals[face[i]];
    for (const std::uint32_t corner : split.corners)
      to.corners.push_back(std::uint32_t(to.vertices.size()) + corner);
    for (const Weights& w : split.points) {
      const Vector p = corners.curved(w);
      const Vector n = corners.normal[0] * w[0] + corners.normal[1] * w[1] + corners.normal[2] * w[2];
      if (!lights.empty()) setLight(lights[face[0]] * w[0] + lights[face[1]] * w[1] + lights[face[2]] * w[2]);
      const double values[9] = {p.x, p.y, p.z, n.x, n.y, n.z, w[0], w[1], w[2]};
      for (int i = 0; i < 3; ++i) {
        vertex.position[i] = float(values[i]);
        vertex.normal[i] = float(values[3 + i]);
        vertex.corner[i] = float(values[6 + i]);
      }
      to.vertices.push_back(vertex);
    }
  }
}

}  // namespace

std::vector<Vector> vertexNormals(const std::vector<Point>& vertices, const std::vector<Face>& faces) {
  std::vector<Vector> normals(vertices.size());
  for (const Face& f : faces) {
    for (int i = 0; i < 3; ++i) {
      const Vector one = vertices[f[(i + 1) % 3]] - vertices[f[i]],
                   other = vertices[f[(i + 2) % 3]] - vertices[f[i]];
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

Surface makeSurface(const OrganismPicture& picture, const EyeAxes& axes, const Framing& framing) {
  std::size_t faces = 0;
  for (const CellShape& cell : picture.cells) faces += facesOf(picture, cell).size();
  const Split split = splitFace(splitsFor(faces));
  Surface surface;
  surface.vertices.reserve(faces * split.points.size());
  surface.corners.reserve(faces * split.corners.size());
  for (const bool solid : {true, false}) {
    for (std::size_t i = 0; i < picture.cells.size(); ++i) {
      const double opacity = picture.cells[i].opacity;
      if (!(opacity > 0 && (opacity >= 1) == solid)) continue;
      const std::size_t first = surface.corners.size();
      addCell(surface, picture, i, axes, framing.centre, split);
      surface.cells.push_back({i, first, surface.corners.size() - first});
    }
    if (solid) surface.solid = surface.corners.size();
  }
  return surface;
}

}  // namespace morula
