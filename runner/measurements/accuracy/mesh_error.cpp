#include "accuracy/mesh_error.h"

#include <algorithm>
#include <cmath>

#include "accuracy/convergence.h"
#include "base/error.h"

namespace morula {
namespace {

/// Order of a mesh's error if only two levels are known: faces are flat, to second order in their edges.
constexpr double assumedMeshOrder = 2;

}  // namespace

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

MeshError estimateMeshError(const std::vector<SolvedMesh>& solved, std::uint64_t own, double eggRadius,
                            std::span<const SceneEvent> events) {
  MORULA_CHECK(solved.size() >= 2, "an error of a mesh needs another mesh");
  MeshError error;
  error.own = own;
  error.until = INFINITY;
  std::vector<RunDistance> toFinest;
  for (std::size_t i = 0; i + 1 < solved.size(); ++i) {
    const auto cut = findDividedElsewhere(solved[i].trial->divisions, solved.back().trial->divisions, anotherPlane);
    if (cut && (!error.cut || cut->time < error.cut->time)) error.cut = cut;
  }
  const ComparisonLimits limits{.before = error.cut ? error.cut->time : INFINITY, .events = events};
  for (std::size_t i = 0; i + 1 < solved.size(); ++i) {
    const RunDistance d = compareRuns(*solved[i].trial, *solved.back().trial, eggRadius, limits);
    error.until = std::min(error.until, d.until), error.touch = d.touch;
    if (d.partedAt && (!error.partedAt || *d.partedAt < *error.partedAt)) error.partedAt = d.partedAt;
    toFinest.push_back(d);
  }
  if (error.until == 0) {
    error.unknown = "on other meshes other cells live, or divide across another plane, from the first comparison on";
    return error;
  }
  const RunDistance fine = toFinest.back();
  bool isQuiet = std::ranges::all_of(toFinest, [](const RunDistance& d) { return d.atRest.has_value(); });
  toFinest.emplace_back().atRest.emplace();  // the finest has no distance from itself
  RunDistance coarse;                        // distance from the third level to the second
  error.orderIsObserved = solved.size() > 2;
  if (error.orderIsObserved)
    coarse = compareRuns(*solved[solved.size() - 3].trial, *solved[solved.size() - 2].trial, eggRadius, limits);
  if (error.orderIsObserved && !coarse.atRest) isQuiet = false;
  const auto left = [&](double coarseToMiddle, double middleToFine) -> LeftError {
    if (error.orderIsObserved) return estimateByRichardson(coarseToMiddle, middleToFine, assumedMeshOrder);
    return {middleToFine / (std::exp2(assumedMeshOrder) - 1), assumedMeshOrder};
  };
  const LeftError whole = left(coarse.worst.largest(), fine.worst.largest());
  error.order = whole.order < minMeshOrder ? 0 : whole.order;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    const bool isFinest = i + 1 == solved.size();
    LevelError level{solved[i].level, toFinest[i].worst, toFinest[i].atEnd};
    if (isQuiet) level.atRest = toFinest[i].atRest;
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
      if (isQuiet) add(*level.atRest.*q.of, coarse.atRest.value_or(StateError{}).*q.of, *fine.atRest.*q.of);
    }
    if (isFinest) level.worst.neighbours = fine.worst.neighbours, level.atEnd.neighbours = fine.atEnd.neighbours;
    if (isFinest && isQuiet) level.atRest->neighbours = fine.atRest->neighbours;
    if (level.level == own) error.atStart = toFinest[i].atStart;
    error.levels.push_back(level);
  }
  return error;
}

}  // namespace morula
