#include "store/cell_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "files/bytes.h"
#include "mesh/mesh_measures.h"

namespace morula {
namespace {

constexpr double steps = 65535;  // number of steps from one side of the box to the other

std::uint16_t numberOf(double x, double low, double step) {
  if (!(step > 0)) return 0;
  return static_cast<std::uint16_t>(std::clamp(std::floor((x - low) / step + 0.5), 0.0, steps));
}

bool isShort(std::uint64_t vertices) { return vertices <= 65536; }

}  // namespace

CellSurface quantise(const CellPath& path, int mesh, const std::vector<Point>& vertices) {
  const auto [low, high] = measureBox(vertices);
  CellSurface s{path, mesh, low, (high - low) / steps, {}};
  s.numbers.reserve(vertices.size());
  for (const Point& x : vertices)
    s.numbers.push_back(
        {numberOf(x.x, low.x, s.step.x), numberOf(x.y, low.y, s.step.y), numberOf(x.z, low.z, s.step.z)});
  return s;
}

std::vector<Point> vertexPositions(const CellSurface& s) {
  std::vector<Point> vertices;
  vertices.reserve(s.numbers.size());
  for (const auto& [x, y, z] : s.numbers)
    vertices.push_back({s.low.x + x * s.step.x, s.low.y + y * s.step.y, s.low.z + z * s.step.z});
  return vertices;
}

std::string numberBytes(const CellSurface& surface) {
  std::string bytes;
  bytes.reserve(6 * surface.numbers.size());
  for (const auto& vertex : surface.numbers)
    for (const std::uint16_t number : vertex) put16(bytes, number);
  return bytes;
}

std::string faceBytes(const MeshFaces& mesh) {
  std::string bytes;
  for (const Face& face : mesh.faces)
    for (const std::int32_t corner : face)
      if (isShort(mesh.vertices)) put16(bytes, static_cast<std::uint16_t>(corner));
      else put32(bytes, corner);
  return bytes;
}

std::vector<std::array<std::uint16_t, 3>> numbersFrom(std::string_view bytes) {
  MORULA_CHECK(bytes.size() % 6 == 0, "three numbers of two bytes a vertex");
  std::vector<std::array<std::uint16_t, 3>> numbers(bytes.size() / 6);
  for (std::size_t i = 0; i < bytes.size() / 2; ++i) numbers[i / 3][i % 3] = numberAt<std::uint16_t>(bytes, 2 * i);
  return numbers;
}

bool facesFrom(std::string_view bytes, std::uint64_t vertices, std::vector<Face>& faces) {
  const std::size_t each = isShort(vertices) ? 2 : 4;
  if (bytes.size() % (3 * each) != 0 || vertices > std::numeric_limits<std::int32_t>::max()) return false;
  faces.assign(bytes.size() / (3 * each), {});
  for (std::size_t i = 0; i < 3 * faces.size(); ++i) {
    const std::uint32_t corner =
        each == 2 ? numberAt<std::uint16_t>(bytes, 2 * i) : numberAt<std::uint32_t>(bytes, 4 * i);
    if (corner >= vertices) return false;
    faces[i / 3][i % 3] = static_cast<std::int32_t>(corner);
  }
  return true;
}

}  // namespace morula
