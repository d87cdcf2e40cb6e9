#include "mesh/cavities.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/error.h"

namespace morula {
namespace {

/// A grid of cubes, numbered with z fastest.
struct Cubes {
  Point low;
  double edge;
  int count[3];         // along x, y, z
  std::size_t step[3];  // to the next cube along x, y, z

  std::size_t size() const { return step[0] * count[0]; }
  int place(std::size_t cube, int axis) const { return static_cast<int>(cube / step[axis] % count[axis]); }
  Point centre(std::size_t cube) const {
    return low + edge * Vector{place(cube, 0) + 0.5, place(cube, 1) + 0.5, place(cube, 2) + 0.5};
  }
  /// Visits the cubes that share a face with this one, up to six.
  void eachNeighbour(std::size_t cube, const auto& visit) const {
    for (int axis = 0; axis < 3; ++axis) {
      const int at = place(cube, axis);
      if (at > 0) visit(cube - step[axis]);
      if (at + 1 < count[axis]) visit(cube + step[axis]);
    }
  }
};
using Marks = std::vector<std::uint8_t>;  // [cube]

/// Marks the cubes whose centres are within `reach` [edges] of the centre of a cube with `isIn`. Adds squared distances
/// axis by axis, as whole numbers.
Marks around(const Cubes& cubes, double reach, const auto& isIn) {
  constexpr std::int16_t far = 10'000;  // much more than reach²
  std::vector<std::int16_t> square(cubes.size()), next;
  for (std::size_t i = 0; i < square.size(); ++i) square[i] = isIn(i) ? 0 : far;
  const int most = static_cast<int>(reach);
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t step = cubes.step[axis], line = step * cubes.count[axis];
    next = square;
    for (std::size_t first = 0; first < square.size(); first += line)
      for (int by = 1; by <= std::min(most, cubes.count[axis] - 1); ++by) {
        const auto more = static_cast<std::int16_t>(by * by);
        const std::size_t off = by * step;
        std::int16_t* out = next.data() + first;
        const std::int16_t* in = square.data() + first;
        for (std::size_t i = 0; i < line - off; ++i) {
          out[i] = std::min<std::int16_t>(out[i], in[i + off] + more);
          out[i + off] = std::min<std::int16_t>(out[i + off], in[i] + more);
        }
      }
    square.swap(next);
  }
  Marks marks(square.size());
  for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = square[i] <= reach * reach;
  return marks;
}

/// Clears the marks of this cube and of all marked cubes connected to it. Returns their number.
std::size_t takePiece(const Cubes& cubes, Marks& marks, std::size_t cube) {
  std::vector<std::size_t> open{cube};
  std::size_t count = 0;
  for (marks[cube] = 0; !open.empty(); ++count) {
    const std::size_t at = open.back();
    open.pop_back();
    cubes.eachNeighbour(at, [&](std::size_t other) {
      if (marks[other]) marks[other] = 0, open.push_back(other);
    });
  }
  return count;
}

constexpr double finest = 16;  // edges in a probe's radius

Cubes cubesAround(std::span<const MeshView> meshes, double probe, double most) {
  const Box box = boxAround(meshes);
  const Vector size = box.high - box.low;
  const double along[] = {size.x, size.y, size.z};
  MORULA_CHECK(probe > 0 && std::isfinite(dot(size, size) / probe), "meshes whose vertices are not finite");
  for (double edge = probe / finest;; edge *= 1.02) {
    const double rim = probe + 2 * edge;  // room for a probe, and for two cubes
    double all = 1;
    for (const double length : along) all *= std::floor((length + 2 * rim) / edge) + 1;
    if (all > most) continue;
    Cubes cubes{box.low - Vector{rim, rim, rim}, edge, {}, {}};
    for (int i = 0; i < 3; ++i) cubes.count[i] = static_cast<int>((along[i] + 2 * rim) / edge) + 1;
    cubes.step[2] = 1, cubes.step[1] = cubes.count[2], cubes.step[0] = cubes.step[1] * cubes.count[1];
    return cubes;
  }
}

Marks cubesInside(std::span<const MeshView> meshes, const Cubes& cubes) {
  Marks inside(cubes.size());
  const auto number = [&](double z) {  // number of the first centre at or above z
    return std::clamp(static_cast<int>(std::ceil((z - cubes.low.z) / cubes.edge - 0.5)), 0, cubes.count[2]);
  };
  visitInside(meshes, cubes.low, cubes.edge, cubes.count[0], cubes.count[1],
              [&](int column, int row, double from, double to) {
                const auto line = inside.begin() + column * cubes.step[0] + row * cubes.step[1];
                std::fill(line + number(from), line + std::max(number(from), number(to)), 1);
              });
  return inside;
}

}  // namespace

Cavities measureCavities(std::span<const MeshView> meshes, double probe, double most) {
  Cavities found;
  if (meshes.empty()) return found;
  const Cubes cubes = cubesAround(meshes, probe, most);
  const double reach = probe / cubes.edge, each = cubes.edge * cubes.edge * cubes.edge;
  found.edge = cubes.edge;
  if (!(reach > 1)) return found;
  const Marks inside = cubesInside(meshes, cubes);
  const Marks wall = around(cubes, reach, [&](std::size_t i) { return inside[i]; });
  Marks shut(wall.size());  // where a probe's centre fits, and cannot get out
  std::transform(wall.begin(), wall.end(), shut.begin(), [](auto w) { return !w; });
  takePiece(cubes, shut, 0);
  for (std::size_t i = 0; i < wall.size(); ++i) {
    bool touches = false;
    if (!wall[i] && !shut[i]) cubes.eachNeighbour(i, [&](std::size_t n) { touches |= wall[n]; });
    if (touches) found.outside.push_back(cubes.centre(i));
  }
  if (std::ranges::none_of(shut, [](auto s) { return s; })) return found;
  Marks pockets = around(cubes, reach, [&](std::size_t i) { return shut[i]; });
  for (std::size_t i = 0; i < pockets.size(); ++i)
    if (pockets[i]) {
      const double volume = each * static_cast<double>(takePiece(cubes, pockets, i));
      found.volume += volume;
      found.largest = std::max(found.largest, volume);
    }
  return found;
}

}  // namespace morula
