#include <algorithm>
#include <map>
#include <utility>

#include "base/error.h"
#include "mesh/mesh.h"

namespace morula {
namespace {

// The corners of three mutually perpendicular golden rectangles are the corners of an icosahedron.
Mesh makeIcosahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  const double length = std::sqrt(1 + golden * golden);
  const double s = 1 / length, g = golden / length;
  // clang-format off
  return {{{-s, g, 0}, {s, g, 0}, {-s, -g, 0}, {s, -g, 0},
           {0, -s, g}, {0, s, g}, {0, -s, -g}, {0, s, -g},
           {g, 0, -s}, {g, 0, s}, {-g, 0, -s}, {-g, 0, s}},
          {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11},   // around vertex 0
           {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},   // their outer neighbours
           {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8}, {3, 8, 9},       // around vertex 3, opposite
           {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}}};  // their outer neighbours
  // clang-format on
}

// Splits each face in four. Each edge gets a new vertex, in the order in which the faces meet the edges.
Mesh split(Mesh mesh) {
  std::map<std::pair<int, int>, int> middles;
  const auto middleOf = [&](int a, int b) {
    const auto [place, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
    if (isNew) {
      const Point sum = mesh.vertices[place->first.first] + mesh.vertices[place->first.second];
      mesh.vertices.push_back(sum / norm(sum));
    }
    return place->second;
  };
  std::vector<Face> faces;
  faces.reserve(4 * mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces) {
    const int ab = middleOf(a, b), bc = middleOf(b, c), ca = middleOf(c, a);
    faces.insert(faces.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  mesh.faces = std::move(faces);
  return mesh;
}

}  // namespace

Mesh makeIcosphere(int level) {
  if (level < 0 || level > 4)
    throw InputError("icosphere " + std::to_string(level) +
                     ": there is no such level; choose 0 to 4 (12, 42, 162, 642 or 2562 vertices)");
  Mesh mesh = makeIcosahedron();
  for (int i = 0; i < level; ++i) mesh = split(std::move(mesh));
  return mesh;
}

}  // namespace morula
