#include "mesh/overlap.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "base/error.h"
#include "mesh/scan_line.h"

namespace morula {
namespace {

// Equidistant lines along one axis: the middles of equal parts of the box's side.
struct Grid {
  double low, spacing;
  int count;

  double at(int i) const { return low + (i + 0.5) * spacing; }
  // Numbers [first, end) of all lines within [from, to], with one more on each side because of rounding.
  std::pair<int, int> linesWithin(double from, double to) const {
    const auto number = [this](double x) {
      return static_cast<int>(std::clamp(std::floor((x - low) / spacing - 0.5), -1.0, static_cast<double>(count)));
    };
    return {std::max(number(from) - 1, 0), std::min(number(to) + 2, count)};
  }
};

struct Triangle {
  int mesh, face;
};

// A point in which a line enters (sign −1) or leaves (+1) a mesh.
struct Crossing {
  double z;
  int mesh, sign;
  bool operator<(const Crossing& o) const { return std::tie(z, mesh, sign) < std::tie(o.z, o.mesh, o.sign); }
};

class Scan {
 public:
  Scan(std::span<const MeshView> meshes, const Grid& x, const Grid& y)
      : meshes_(meshes),
        x_(x),
        y_(y),
        crossings_(x.count),
        inside_(meshes.size(), 0.0),
        shared_(inside_),
        wound_(inside_),
        repeated_(inside_) {}
  Scan(std::span<const MeshView> meshes, const Box& box, int columns)
      : Scan(meshes, {box.low.x, (box.high.x - box.low.x) / columns, columns},
             {box.low.y, (box.high.y - box.low.y) / columns, columns}) {}

  Overlap run() {
    sweepAll({});
    Overlap result;
    const double cell = x_.spacing * y_.spacing;
    for (std::size_t m = 0; m < meshes_.size(); ++m) {
      result.volumes.push_back(inside_[m] * cell);
      result.shares.push_back(inside_[m] > 0 ? shared_[m] / inside_[m] : 0);
      result.selfShares.push_back(wound_[m] > 0 ? repeated_[m] / wound_[m] : 0);
    }
    result.unionVolume = union_ * cell;
    return result;
  }

  /// [length³] The part of mesh number `mesh` that also lies in other meshes.
  double sharedVolume(int mesh) {
    sweepAll({});
    return shared_[mesh] * x_.spacing * y_.spacing;
  }

  /// Calls visit(column, row, from, to) for each interval of a line that lies in a mesh.
  void sweepAll(const std::function<void(int, int, double, double)>& visit) {
    sortTrianglesByRow();
    for (int row = 0; row < y_.count; ++row) {
      collectCrossings(row);
      for (int column = 0; column < x_.count; ++column) {
        std::vector<Crossing>& crossings = crossings_[column];
        std::sort(crossings.begin(), crossings.end());
        sweep(crossings, [&](double from, double to) {
          if (visit) visit(column, row, from, to);
        });
        crossings.clear();
      }
    }
  }

 private:
  // Counting sort of (row, triangle): row r has rows_[rowStart_[r], rowStart_[r + 1]).
  void sortTrianglesByRow() {
    rowStart_.assign(y_.count + 1, 0);
    forEachRowOfEachTriangle([this](int row, const Triangle&) { ++rowStart_[row + 1]; });
    for (int r = 0; r < y_.count; ++r) rowStart_[r + 1] += rowStart_[r];
    rows_.resize(rowStart_.back());
    std::vector<std::size_t> next(rowStart_.begin(), rowStart_.end() - 1);
    forEachRowOfEachTriangle([&](int row, const Triangle& t) { rows_[next[row]++] = t; });
  }

  template <class Action>
  void forEachRowOfEachTriangle(Action action) const {
    for (int m = 0; m < static_cast<int>(meshes_.size()); ++m)
      for (int f = 0; f < static_cast<int>(meshes_[m].faces.size()); ++f) {
        const auto& [a, b, c] = meshes_[m].faces[f];
        const Points& v = meshes_[m].vertices;
        const auto [low, high] = std::minmax({v[a].y, v[b].y, v[c].y});
        const auto [first, end] = y_.linesWithin(low, high);
        for (int row = first; row < end; ++row) action(row, Triangle{m, f});
      }
  }

  void collectCrossings(int row) {
    const double y = y_.at(row);
    for (std::size_t i = rowStart_[row]; i < rowStart_[row + 1]; ++i) {
      const auto [m, f] = rows_[i];
      const auto& [a, b, c] = meshes_[m].faces[f];
      const Points& v = meshes_[m].vertices;
      Slice s;
      if (!slice(v[a], v[b], v[c], y, s)) continue;
      const auto [first, end] = x_.linesWithin(s.xLow, s.xHigh);
      for (int column = first; column < end; ++column)
        if (const double x = x_.at(column); s.meets(x)) crossings_[column].push_back({s.heightAt(x), m, s.sign});
    }
  }

  // Goes up one line and adds the length of each interval to the meshes that it lies in.
  void sweep(const std::vector<Crossing>& crossings, const auto& visit) {
    around_.clear();
    double below = 0;
    for (const Crossing& c : crossings) {
      const double length = c.z - below;
      int count = 0;
      for (const auto& [mesh, winding] : around_) count += winding > 0;
      if (count > 0) union_ += length, visit(below, c.z);
      for (const auto& [mesh, winding] : around_) {
        wound_[mesh] += length;
        if (winding != 1) repeated_[mesh] += length;
        if (winding <= 0) continue;
        inside_[mesh] += length;
        if (count > 1) shared_[mesh] += length;
      }
      below = c.z;
      turn(c.mesh, -c.sign);
    }
    MORULA_CHECK(around_.empty(), "a line that does not come out of a closed mesh");
  }

  void turn(int mesh, int by) {
    const auto place = std::find_if(around_.begin(), around_.end(), [mesh](const auto& a) { return a.first == mesh; });
    if (place == around_.end()) around_.emplace_back(mesh, by);
    else if ((place->second += by) == 0) around_.erase(place);
  }

  std::span<const MeshView> meshes_;
  Grid x_, y_;
  std::vector<std::size_t> rowStart_;
  std::vector<Triangle> rows_;
  std::vector<std::vector<Crossing>> crossings_;  // of the current row, per column
  std::vector<std::pair<int, int>> around_;       // meshes, and their winding numbers around the current interval
  std::vector<double> inside_, shared_;           // [length] per mesh, over all lines
  std::vector<double> wound_, repeated_;  // [length] per mesh: with a winding number, and with one that is not 1
  double union_ = 0;                      // [length]
};

}  // namespace

double Overlap::meanShare() const {
  double sum = 0;
  for (double s : shares) sum += s;
  return shares.empty() ? 0 : sum / static_cast<double>(shares.size());
}

Box boxAround(std::span<const MeshView> meshes) {
  Box box = measureBox(meshes[0].vertices);
  for (const MeshView& mesh : meshes) {
    const Box other = measureBox(mesh.vertices);
    box.low = {std::min(box.low.x, other.low.x), std::min(box.low.y, other.low.y), std::min(box.low.z, other.low.z)};
    box.high = {std::max(box.high.x, other.high.x), std::max(box.high.y, other.high.y),
                std::max(box.high.z, other.high.z)};
  }
  return box;
}

Overlap measureOverlap(std::span<const MeshView> meshes, int columns) {
  MORULA_CHECK(columns > 0, "no columns, no lines");
  if (meshes.empty()) return {};
  const Box box = boxAround(meshes);
  const Vector size = box.high - box.low;
  MORULA_CHECK(std::isfinite(dot(size, size)), "meshes whose vertices are not finite");
  const std::vector<double> nothing(meshes.size());
  if (!(size.x > 0 && size.y > 0)) return {nothing, nothing, nothing, 0};
  return Scan(meshes, box, columns).run();
}

void visitInside(std::span<const MeshView> meshes, const Point& low, double spacing, int columns, int rows,
                 const std::function<void(int, int, double, double)>& visit) {
  Scan(meshes, {low.x, spacing, columns}, {low.y, spacing, rows}).sweepAll(visit);
}

double measureSharedVolume(const MeshView& a, const MeshView& b, int columns) {
  MORULA_CHECK(columns > 0, "no columns, no lines");
  const Box here = measureBox(a.vertices), there = measureBox(b.vertices);
  const Box both{
      {std::max(here.low.x, there.low.x), std::max(here.low.y, there.low.y), std::max(here.low.z, there.low.z)},
      {std::min(here.high.x, there.high.x), std::min(here.high.y, there.high.y), std::min(here.high.z, there.high.z)}};
  if (!(both.low.x < both.high.x && both.low.y < both.high.y && both.low.z < both.high.z)) return 0;
  const MeshView meshes[] = {a, b};
  return Scan(meshes, both, columns).sharedVolume(0);
}

double measureSelfOverlap(const MeshView& mesh, int columns) {
  double sum = 0;
  std::vector<Point> turned(mesh.vertices.begin(), mesh.vertices.end());
  for (int axis = 0; axis < 3; ++axis) {
    const MeshView view{turned, mesh.faces};
    sum += measureOverlap({&view, 1}, columns).selfShares[0];
    for (Point& p : turned) p = {p.y, p.z, p.x};
  }
  return sum / 3;
}

bool isStarShaped(const MeshView& mesh, const Point& centre) {
  const Points& v = mesh.vertices;
  for (const auto& [a, b, c] : mesh.faces)
    if (!(dot(cross(v[b] - v[a], v[c] - v[a]), v[a] - centre) > 0)) return false;
  // Counts how often the surface covers the direction +z; since all faces look outward, all directions are alike.
  int covered = 0;
  Slice s;
  for (const auto& [a, b, c] : mesh.faces)
    if (slice(v[a], v[b], v[c], centre.y, s) && s.meets(centre.x) && s.heightAt(centre.x) > centre.z) covered += s.sign;
  return covered == 1;
}

}  // namespace morula
