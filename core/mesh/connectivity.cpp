#include "mesh/connectivity.h"

#include <algorithm>

#include "base/error.h"

namespace morula {
namespace {

// The two other corners of one face of a vertex, in the face's direction of turning.
struct Corner {
  int from, to;
};

std::vector<std::array<int, 2>> findEdges(const std::vector<Face>& faces) {
  std::vector<std::array<int, 2>> edges;
  for (const Face& face : faces)
    for (int k = 0; k < 3; ++k) {
      const int a = face[k], b = face[(k + 1) % 3];
      if (a < b) edges.push_back({a, b});  // the face on the other side runs from b to a
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Walks the fan around a vertex: each corner ends where the next one begins.
void appendRing(const std::vector<Corner>& corners, std::vector<int>& ringVertex) {
  const auto before = [](const Corner& a, const Corner& b) { return a.from < b.from; };
  const int first = std::min_element(corners.begin(), corners.end(), before)->from;
  int at = first;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    MORULA_CHECK(k == 0 || at != first, "a vertex with more than one fan of faces");
    ringVertex.push_back(at);
    const auto next = std::find_if(corners.begin(), corners.end(), [at](const Corner& c) { return c.from == at; });
    MORULA_CHECK(next != corners.end(), "a vertex whose faces do not close around it");
    at = next->to;
  }
  MORULA_CHECK(at == first, "a vertex whose faces do not close around it");
}

}  // namespace

Connectivity makeConnectivity(const Mesh& mesh) {
  Connectivity c;
  c.vertexCount = static_cast<int>(mesh.vertices.size());
  c.faces = mesh.faces;
  c.edges = findEdges(mesh.faces);
  c.edgeCount = static_cast<int>(c.edges.size());

  std::vector<std::vector<Corner>> corners(c.vertexCount);
  for (const Face& face : mesh.faces)
    for (int k = 0; k < 3; ++k) corners[face[k]].push_back({face[(k + 1) % 3], face[(k + 2) % 3]});

  c.ringStart.push_back(0);
  for (int i = 0; i < c.vertexCount; ++i) {
    MORULA_CHECK(!corners[i].empty(), "a vertex without a face");
    appendRing(corners[i], c.ringVertex);
    c.ringStart.push_back(static_cast<int>(c.ringVertex.size()));
    for (int k = c.ringStart[i]; k < c.ringStart[i + 1]; ++k) {
      const int j = c.ringVertex[k];
      const std::array<int, 2> edge = {std::min(i, j), std::max(i, j)};
      const auto place = std::lower_bound(c.edges.begin(), c.edges.end(), edge);
      MORULA_CHECK(place != c.edges.end() && *place == edge, "an edge with one face");
      c.ringEdge.push_back(static_cast<int>(place - c.edges.begin()));
    }
  }
  return c;
}

}  // namespace morula
