#include "accuracy/state_error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/error.h"
#include "mesh/distance.h"
#include "mesh/mesh_measures.h"
#include "observation/measures.h"
#include "simulation/simulation.h"

namespace morula {
namespace {

/// Returns the centre of the enclosed volume, summed over tetrahedra from the vertices' mean; the centre of each is a
/// quarter of its corners' sum. Returns the vertices' mean if nothing is enclosed.
Point volumeCentroid(const Mesh& mesh) {
  const Point origin = measureCentroid(mesh.vertices);
  Vector moment;
  double sixfold = 0;
  for (const Face& f : mesh.faces) {
    const Vector a = mesh.vertices[f[0]] - origin, b = mesh.vertices[f[1]] - origin, c = mesh.vertices[f[2]] - origin;
    const double part = dot(a, cross(b, c));  // six times the volume of a tetrahedron
    sixfold += part;
    moment += part / 4 * (a + b + c);
  }
  return sixfold > 0 ? origin + moment / sixfold : origin;
}

}  // namespace

ComparedCell comparedCell(const CellPath& path, Mesh surface) {
  ComparedCell cell{path, std::move(surface), {}};
  cell.centroid = volumeCentroid(cell.surface);
  cell.volume = measureVolume(cell.surface.vertices, cell.surface.faces);
  return cell;
}

Shapes takeShapes(const World& world) {
  const Observation now(world);
  Shapes shapes{world.clock.time, {}, measureContacts(now)};
  for (int i = 0; world.bodies && i < world.bodies->count; ++i) {
    const ObservedCell cell(now, i);
    const BodyShape& shape = cell.physical()->getShape();
    shapes.cells.push_back(comparedCell(cell.path, shape.surface));
    shapes.cells.back().pressure = shape.pressure.value_or(0);
  }
  return shapes;
}

std::string nameOf(const ErrorQuantity& quantity) {
  std::string name = quantity.name;
  std::ranges::replace(name, '_', ' ');
  return name;
}

double StateError::largest() const { return std::max({centroid, volume, surface}); }

bool haveSameCells(const Shapes& a, const Shapes& b) {
  return std::equal(a.cells.begin(), a.cells.end(), b.cells.begin(), b.cells.end(),
                    [](const ComparedCell& x, const ComparedCell& y) { return x.path == y.path; });
}

StateError compareShapes(const Shapes& shapes, const Shapes& reference, double eggRadius) {
  MORULA_CHECK(haveSameCells(shapes, reference), "only the same cells can be compared");
  StateError worst;
  for (std::size_t i = 0; i < shapes.cells.size(); ++i) {
    const ComparedCell &a = shapes.cells[i], &b = reference.cells[i];
    worst.centroid = std::max(worst.centroid, norm(a.centroid - b.centroid) / eggRadius);
    worst.volume = std::max(worst.volume, std::abs(a.volume / b.volume - 1));
    worst.surface = std::max(worst.surface, measureSurfaceDistance(a.surface, b.surface) / eggRadius);
  }
  return worst;
}

std::optional<DividedElsewhere> findDividedElsewhere(std::span<const DivisionRecord> divisions,
                                                     std::span<const DivisionRecord> reference, double least) {
  for (const DivisionRecord& there : reference) {  // by time
    const auto here = std::ranges::find(divisions, there.path, &DivisionRecord::path);
    if (here == divisions.end()) continue;
    // The axis points to daughter A: the same plane with exchanged daughters is the largest difference.
    const double cosine = std::clamp(dot(here->axis, there.axis), -1.0, 1.0);
    const double angle = std::acos(cosine) * 180 / std::numbers::pi;
    if (angle > least) return DividedElsewhere{there.path, there.time, angle, there.extentRatio};
  }
  return {};
}

double compareBirths(std::span<const LineageEntry> a, std::span<const LineageEntry> b) {
  std::map<CellPath, double> born;
  for (const LineageEntry& e : a) born[e.path] = e.born;
  double largest = 0;
  for (const LineageEntry& e : b)
    if (const auto same = born.find(e.path); same != born.end())
      largest = std::max(largest, std::abs(same->second - e.born));
  return largest;
}

}  // namespace morula
