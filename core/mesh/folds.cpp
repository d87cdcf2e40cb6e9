#include "mesh/folds.h"

#include <algorithm>
#include <tuple>

#include "base/error.h"

namespace morula {

EdgeFaces findEdgeFaces(Faces faces) {
  std::vector<std::tuple<int, int, int>> sides;  // the edge's smaller vertex, its larger one, a face at it
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(faces[f][k], faces[f][(k + 1) % 3]);
      sides.emplace_back(low, high, f);
    }
  std::sort(sides.begin(), sides.end());
  MORULA_CHECK(sides.size() % 2 == 0, "each edge of a closed mesh has two faces");
  EdgeFaces edges;
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
    edges.push_back({std::get<2>(sides[i]), std::get<2>(sides[i + 1])});
  return edges;
}

namespace {

std::vector<Vector> normalsOf(Points vertices, Faces faces) {
  std::vector<Vector> normals;
  for (const auto& [a, b, c] : faces) normals.push_back(cross(vertices[b] - vertices[a], vertices[c] - vertices[a]));
  return normals;
}

}  // namespace

EdgeFaces findFlatEdges(Points vertices, Faces faces) {
  EdgeFaces edges = findEdgeFaces(faces);
  const std::vector<Vector> normals = normalsOf(vertices, faces);
  std::erase_if(edges, [&](const std::array<int, 2>& edge) { return dot(normals[edge[0]], normals[edge[1]]) < 0; });
  return edges;
}

int countFolded(Points vertices, Faces faces, const EdgeFaces& edges) {
  const std::vector<Vector> normals = normalsOf(vertices, faces);
  return static_cast<int>(std::ranges::count_if(
      edges, [&](const std::array<int, 2>& edge) { return dot(normals[edge[0]], normals[edge[1]]) < 0; }));
}

}  // namespace morula
