#include "report_data/frame_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

#include "mesh/nesting.h"

namespace morula {
namespace {

constexpr int finest = 4, coarsest = 1;  // levels of icospheres

const std::vector<Face>& icosphereFaces(int level) {
  static const auto all = [] {
    std::array<std::vector<Face>, finest + 1> faces;
    for (int i = 0; i <= finest; ++i) faces[static_cast<std::size_t>(i)] = makeIcosphere(i).faces;
    return faces;
  }();
  return all[static_cast<std::size_t>(level)];
}

/// Returns the level of the icosphere with these faces; -1: another mesh.
int levelOf(const std::vector<Face>& faces) {
  for (int level = 0; level <= finest; ++level)
    if (faces.size() == icosphereFaces(level).size()) return faces == icosphereFaces(level) ? level : -1;
  return -1;
}

std::size_t vertexCount(const std::vector<Face>& faces) {
  std::size_t count = 0;
  for (const Face& face : faces)
    for (const auto v : face) count = std::max(count, static_cast<std::size_t>(v) + 1);
  return count;
}

}  // namespace

std::size_t placesOf(const FrameMesh& mesh) { return mesh.ball.empty() ? vertexCount(mesh.faces) : 0; }

FrameMesh ballFor(std::size_t spheres) {
  Mesh ball = makeIcosphere(spheres * 162 <= maxBallVertices ? 2 : 1);
  return {std::move(ball.faces), std::move(ball.vertices)};
}

int levelsCoarser(std::size_t vertices) {
  int levels = 0;
  for (; vertices > maxDrawnVertices; vertices /= 4) ++levels;
  return levels;
}

Mesh coarserShape(Mesh shape, int levels) {
  for (int level = levelOf(shape.faces); levels > 0 && level > coarsest; --levels) {
    const std::vector<Face>& faces = icosphereFaces(--level);
    std::vector<std::int32_t> nested(vertexCount(faces));
    std::iota(nested.begin(), nested.end(), 0);
    shape = {restrictShape(shape.vertices, shape.faces, nested, faces), faces};
  }
  return shape;
}

}  // namespace morula
