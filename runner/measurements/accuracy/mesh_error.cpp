#include "accuracy/mesh_error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "accuracy/convergence.h"
#include "base/error.h"

namespace morula {
namespace {

/// Order of a mesh's error if only two levels are known: faces are flat, to second order in their edges.
constexpr double assumedMeshOrder = 2;

double largestPressure(const Shapes& shapes) {
  double largest = 0;
  for (const ComparedCell& cell : shapes.cells) largest = std::max(largest, std::abs(cell.pressure));
  return largest;
}

double largestArea(const Shapes& shapes) {
  double largest = 0;
  for (const ContactMeasures& contact : shapes.contacts) largest = std::max(largest, contact.at("area"));
  return largest;
}

double pressureDifference(const Shapes& a, const Shapes& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.cells.size(); ++i)
    largest = std::max(largest, std::abs(a.cells[i].pressure - b.cells[i].pressure));
  return largest;
}

/// The differences of the pairs of cells that touch in either world.
struct PairDifference {
  double area = 0;  // the largest difference
  int pairs = 0, inOneAlone = 0;
};

PairDifference comparePairs(const Shapes& a, const Shapes& b) {
  std::map<std::pair<CellPath, CellPath>, std::vector<double>> areas;
  for (const ContactMeasures& pair : a.contacts) areas[{pair.a, pair.b}].push_back(pair.at("area"));
  for (const ContactMeasures& pair : b.contacts) areas[{pair.a, pair.b}].push_back(-pair.at("area"));
  PairDifference d;
  for (const auto& [pair, of] : areas) {
    d.area = std::max(d.area, std::abs(std::accumulate(of.begin(), of.end(), 0.0)));
    ++d.pairs, d.inOneAlone += of.size() == 1;
  }
  return d;
}

/// Returns difference / scale; 0 if both are 0, 1 if only the scale is 0.
double over(double difference, double scale) { return difference == 0 ? 0 : scale == 0 ? 1 : difference / scale; }

}  // namespace

std::optional<double> RunDistance::error() const { return until > 0 ? std::optional(worst.largest()) : std::nullopt; }

RunDistance compareRuns(const Trial& trial, const Trial& reference, double eggRadius, double before) {
  RunDistance d;
  double pressure = 0, pressureScale = 0, area = 0, areaScale = 0, pairs = 0, inOneAlone = 0;
  for (std::size_t i = 0; i < std::min(trial.shapes.size(), reference.shapes.size()); ++i) {
    const Shapes &a = trial.shapes[i], &b = reference.shapes[i];
    if (b.time >= before) break;
    if (!haveSameCells(a, b)) {
      d.partedAt = b.time;
      break;
    }
    StateError e = compareShapes(a, b, eggRadius);
    if (i == 0) {
      d.atStart = e.surface;
      continue;
    }
    const double p = pressureDifference(a, b);
    const PairDifference pair = comparePairs(a, b);
    e.pressure = over(p, largestPressure(b)), e.contactArea = over(pair.area, largestArea(b));
    e.neighbours = over(pair.inOneAlone, pair.pairs);
    d.atEnd = e;
    pressure = std::max(pressure, p), pressureScale = std::max(pressureScale, largestPressure(b));
    area = std::max(area, pair.area), areaScale = std::max(areaScale, largestArea(b));
    pairs += pair.pairs, inOneAlone += pair.inOneAlone;
    for (const ErrorQuantity& q : errorQuantities) d.worst.*q.of = std::max(d.worst.*q.of, e.*q.of);
    d.until = b.time;
  }
  // Pressures and areas pass through 0, so their scale is the largest over all times. A pair may touch a moment sooner
  // in one run, so its share is over all times.
  d.worst.pressure = over(pressure, pressureScale), d.worst.contactArea = over(area, areaScale);
  d.worst.neighbours = over(inOneAlone, pairs);
  d.touch = pairs > 0;
  return d;
}

const LevelError* MeshError::find(std::uint64_t level) const {
  const auto found = std::ranges::find(levels, level, &LevelError::level);
  return found == levels.end() ? nullptr : &*found;
}

std::optional<double> MeshError::error() const { return errorOf(own); }

std::optional<double> MeshError::errorOf(std::uint64_t level) const {
  if (none) return 0;
  if (!unknown.empty() || levels.empty()) return {};
  if (const LevelError* known = find(level)) return known->worst.largest();
  const LevelError& finest = levels.back();
  if (level < finest.level || order == 0) return {};
  return finest.worst.largest() * std::exp2(-order * static_cast<double>(level - finest.level));
}

MeshError estimateMeshError(const std::vector<SolvedMesh>& solved, std::uint64_t own, double eggRadius) {
  MORULA_CHECK(solved.size() >= 2, "an error of a mesh needs another mesh");
  MeshError error;
  error.own = own;
  error.until = INFINITY;
  std::vector<RunDistance> toFinest;
  for (std::size_t i = 0; i + 1 < solved.size(); ++i) {
    const auto cut = findDividedElsewhere(solved[i].trial->divisions, solved.back().trial->divisions, anotherPlane);
    if (cut && (!error.cut || cut->time < error.cut->time)) error.cut = cut;
  }
  const double before = error.cut ? error.cut->time : INFINITY;
  for (std::size_t i = 0; i + 1 < solved.size(); ++i) {
    const RunDistance d = compareRuns(*solved[i].trial, *solved.back().trial, eggRadius, before);
    error.until = std::min(error.until, d.until), error.touch = d.touch;
    if (d.partedAt && (!error.partedAt || *d.partedAt < *error.partedAt)) error.partedAt = d.partedAt;
    toFinest.push_back(d);
  }
  if (error.until == 0) {
    error.unknown = "on other meshes other cells live, or divide across another plane, from the first comparison on";
    return error;
  }
  const RunDistance fine = toFinest.back();
  toFinest.emplace_back();  // the finest has no distance from itself
  RunDistance coarse;       // distance from the third level to the second
  error.orderIsObserved = solved.size() > 2;
  if (error.orderIsObserved)
    coarse = compareRuns(*solved[solved.size() - 3].trial, *solved[solved.size() - 2].trial, eggRadius, before);
  const auto left = [&](double coarseToMiddle, double middleToFine) -> LeftError {
    if (error.orderIsObserved) return estimateByRichardson(coarseToMiddle, middleToFine, assumedMeshOrder);
    return {middleToFine / (std::exp2(assumedMeshOrder) - 1), assumedMeshOrder};
  };
  const LeftError whole = left(coarse.worst.largest(), fine.worst.largest());
  error.order = whole.order < minMeshOrder ? 0 : whole.order;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    const bool isFinest = i + 1 == solved.size();
    LevelError level{solved[i].level, toFinest[i].worst, toFinest[i].atEnd};
    // A value that does not converge cannot be extrapolated: the measured distance is kept as a lower bound. The error
    // of the finest mesh is then its last change.
    const auto add = [&](double& to, double coarseToMiddle, double middleToFine) {
      const LeftError l = left(coarseToMiddle, middleToFine);
      if (l.order >= minMeshOrder) to += l.error;
      else if (isFinest) to = std::max(coarseToMiddle, middleToFine);
    };
    for (const ErrorQuantity& q : errorQuantities) {
      if (q.of == &StateError::neighbours) continue;  // touching has no order, so its distance is kept
      add(level.worst.*q.of, coarse.worst.*q.of, fine.worst.*q.of);
      add(level.atEnd.*q.of, coarse.atEnd.*q.of, fine.atEnd.*q.of);
    }
    if (isFinest) level.worst.neighbours = fine.worst.neighbours, level.atEnd.neighbours = fine.atEnd.neighbours;
    if (level.level == own) error.atStart = toFinest[i].atStart;
    error.levels.push_back(level);
  }
  return error;
}

}  // namespace morula
