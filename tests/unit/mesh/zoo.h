#pragma once
// Closed meshes of many kinds, for properties that hold for all of them.
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "mesh/mesh.h"
#include "mesh/mesh_measures.h"

namespace morula::zoo {

struct Animal {
  std::string name;
  Mesh mesh;
  int handles = 0;  // genus: the Euler characteristic is 2 − 2 · handles
};

inline Mesh tetrahedron() {
  return {{{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// Returns a box with its faces split along one diagonal.
inline Mesh box(const Point& low, const Point& high) {
  Mesh m;
  for (int i = 0; i < 8; ++i)
    m.vertices.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& q : quads) {
    m.faces.push_back({q[0], q[1], q[2]});
    m.faces.push_back({q[0], q[2], q[3]});
  }
  return m;
}

/// Returns a ring of `around` × `across` corners, with radii 2 (ring) and 1 (tube) and rational points of the circle.
inline Mesh torus(int around, int across) {
  const auto circle = [](int k, int n) {
    // Returns corner k of a closed polygon on the unit circle: halves by symmetry, then the rational parametrisation.
    const double t = 2.0 * k / n, u = t < 1 ? 2 * t - 1 : 2 * (t - 1) - 1, w = 1 + u * u;
    const double c = 2 * u / w, s = (1 - u * u) / w;
    return t < 1 ? std::pair(-c, s) : std::pair(c, -s);
  };
  Mesh m;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const auto [ca, sa] = circle(i, around);
      const auto [cb, sb] = circle(j, across);
      m.vertices.push_back({(2 + cb) * ca, (2 + cb) * sa, sb});
    }
  const auto at = [=](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      m.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      m.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return m;
}

inline Mesh moved(Mesh m, const Vector& by) {
  for (Point& v : m.vertices) v += by;
  return m;
}

inline Mesh scaled(Mesh m, const Vector& by) {
  for (Point& v : m.vertices) v = {v.x * by.x, v.y * by.y, v.z * by.z};
  return m;
}

/// Returns the mesh with each vertex moved along its direction from the origin by a random share up to `size`.
inline Mesh crumpled(Mesh m, double size, std::uint64_t seed) {
  for (std::size_t i = 0; i < m.vertices.size(); ++i) {
    const double u = randomUnit({seed, {}, 0, Purpose::test}, static_cast<std::uint32_t>(i));
    m.vertices[i] *= 1 + size * (2 * u - 1);
  }
  return m;
}

/// Returns a ball of radius 1 drawn into a sausage along an arc of `angle` [rad] and radius 1. From about 4.9 on its
/// ends overlap.
inline Mesh bent(Mesh ball, double angle) {
  for (Point& p : ball.vertices) {
    const double along = 0.5 * angle * p.x, r = 1 + 0.35 * p.y;
    p = {r * std::sin(along), r * std::cos(along), 0.35 * p.z};
  }
  return ball;
}

/// Returns a ball of radius 1 dented from above, by so wide a dent [length²], which leans towards x. From a depth of
/// about 2 on the dent goes through the bottom.
inline Mesh dented(Mesh ball, double depth, double width = 0.16, double lean = 0) {
  for (Point& p : ball.vertices)
    if (p.z > 0) p -= depth * std::exp(-(p.x * p.x + p.y * p.y) / width) * Vector{lean, 0, 1};
  return ball;
}

/// Returns the mesh turned by three angles that depend on `key`.
inline Mesh turned(Mesh m, std::uint32_t key) {
  for (int axis = 0; axis < 3; ++axis) {
    const double angle = 2.4 * key + 1.7 * axis + 0.3 * key * axis, c = std::cos(angle), s = std::sin(angle);
    for (Point& p : m.vertices) p = {p.y, c * p.z - s * p.x, s * p.z + c * p.x};
  }
  return m;
}

inline Mesh inverted(Mesh m) {
  for (Face& f : m.faces) std::swap(f[1], f[2]);
  return m;
}

inline std::vector<Animal> all() {
  std::vector<Animal> zoo;
  for (int level = 0; level <= 4; ++level) zoo.push_back({"icosphere " + std::to_string(level), makeIcosphere(level)});
  zoo.push_back({"tetrahedron", tetrahedron()});
  zoo.push_back({"cube", box({-1, -1, -1}, {1, 1, 1})});
  zoo.push_back({"torus", torus(12, 8), 1});
  zoo.push_back({"smallest torus", torus(3, 3), 1});
  zoo.push_back({"crumpled ball", crumpled(makeIcosphere(3), 0.3, 7)});
  zoo.push_back({"egg", scaled(makeIcosphere(2), {27, 15, 11})});
  zoo.push_back({"far away", moved(makeIcosphere(2), {1000, -2000, 3000})});
  return zoo;
}

/// Returns the mesh as the text of an OBJ file.
inline std::string objOf(const Mesh& mesh, const std::string& lineEnd = "\n") {
  const auto shortest = [](double v) -> std::string {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, v).ptr};
  };
  std::string text;
  for (const Point& v : mesh.vertices)
    text += "v " + shortest(v.x) + " " + shortest(v.y) + " " + shortest(v.z) + lineEnd;
  for (const Face& f : mesh.faces)
    text += "f " + std::to_string(f[0] + 1) + " " + std::to_string(f[1] + 1) + " " + std::to_string(f[2] + 1) + lineEnd;
  return text;
}

inline double volumeOf(const Mesh& m) { return measureVolume(m.vertices, m.faces); }

}  // namespace morula::zoo
