// The distance of two runs: at each time that both have, and over these.
#include "accuracy/run_distance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "system/clock.h"

namespace morula {
namespace {

bool isSameTime(double a, double b) { return std::abs(a - b) <= timeSlack * std::max(a, b); }

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

/// The differences at one time. Pressures and areas pass through 0, so their scale is the largest over all times; until
/// it is known, `error` holds them in their own units.
struct Moment {
  StateError error;
  PairDifference pair;
  bool isQuiet = false;
};

/// Returns the share of the touching pairs, over the moments, that touch in one world alone. Unlike a median it tells of
/// few pairs.
double neighboursIn(const std::vector<const Moment*>& moments) {
  double pairs = 0, inOneAlone = 0;
  for (const Moment* m : moments) pairs += m->pair.pairs, inOneAlone += m->pair.inOneAlone;
  return over(inOneAlone, pairs);
}

double largestOf(std::vector<double> values) { return std::ranges::max(values); }

/// Sums up each quantity over the moments by `sum`. Requires a moment.
StateError sumUp(const std::vector<const Moment*>& moments, double (*sum)(std::vector<double>)) {
  StateError e;
  for (const ErrorQuantity& q : errorQuantities) {
    std::vector<double> values;
    for (const Moment* m : moments) values.push_back(m->error.*q.of);
    e.*q.of = sum(std::move(values));
  }
  return e;
}

/// Returns the first shape from `from` on that is not before the time.
std::size_t firstFrom(const std::vector<Shapes>& shapes, std::size_t from, double time) {
  while (from < shapes.size() && shapes[from].time < time && !isSameTime(shapes[from].time, time)) ++from;
  return from;
}

/// Returns true if the time is 0 or one of `at`, or `at` is empty.
bool isCompared(std::span<const double> at, double time) {
  return time == 0 || at.empty() || std::ranges::any_of(at, [&](double t) { return isSameTime(t, time); });
}

}  // namespace

std::optional<double> RunDistance::error() const { return until > 0 ? std::optional(worst.largest()) : std::nullopt; }

RunDistance compareRuns(const Trial& trial, const Trial& reference, double eggRadius, const ComparisonLimits& limits) {
  RunDistance d;
  std::vector<Moment> moments;
  double pressureScale = 0, areaScale = 0;
  std::size_t other = 0;
  for (const Shapes& a : trial.shapes) {
    other = firstFrom(reference.shapes, other, a.time);
    if (other == reference.shapes.size()) break;
    const Shapes& b = reference.shapes[other];
    if (!isSameTime(a.time, b.time) || !isCompared(limits.at, a.time)) continue;
    if (b.time >= limits.before) break;
    if (!haveSameCells(a, b)) {
      d.partedAt = b.time;
      break;
    }
    StateError e = compareShapes(a, b, eggRadius);
    if (b.time == 0) {
      d.atStart = e.surface;
      continue;
    }
    const PairDifference pair = comparePairs(a, b);
    e.pressure = pressureDifference(a, b), e.contactArea = pair.area;
    e.neighbours = over(pair.inOneAlone, pair.pairs);
    d.atEnd = e;
    d.atEnd.pressure = over(e.pressure, largestPressure(b)), d.atEnd.contactArea = over(pair.area, largestArea(b));
    pressureScale = std::max(pressureScale, largestPressure(b)), areaScale = std::max(areaScale, largestArea(b));
    d.touch = d.touch || pair.pairs > 0;
    d.until = b.time;
    moments.push_back({e, pair, isQuiet(limits.events, b.time)});
  }
  std::vector<const Moment*> all, quiet;
  for (Moment& m : moments) {
    m.error.pressure = over(m.error.pressure, pressureScale),
    m.error.contactArea = over(m.error.contactArea, areaScale);
    all.push_back(&m);
    if (m.isQuiet) quiet.push_back(&m);
  }
  if (!all.empty()) d.worst = sumUp(all, largestOf);
  if (quiet.empty()) return d;
  d.atRest = sumUp(quiet, median);
  d.atRest->neighbours = neighboursIn(quiet);
  return d;
}

}  // namespace morula
