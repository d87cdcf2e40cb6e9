// The metrics in which two engines may honestly be held against each other.
#include <algorithm>
#include <cmath>

#include "engines/bullet_check.h"
#include "mesh/measures.h"
#include "scenario/numbers.h"
#include "simulation/measures.h"

namespace morula {

namespace {

using scenario::formatReal;
using Shape = std::vector<Point>;

/// √(largest/smallest second moment about the centre): 1 for a sphere, a/c for an ellipsoid. The moments are
/// the roots of the characteristic polynomial of their matrix, by Viète's formula.
double aspect(const Shape& shape) {
  const Point centre = measureCentroid(shape);
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  for (const Point& p : shape) {
    const Vector d = p - centre;
    xx += d.x * d.x, yy += d.y * d.y, zz += d.z * d.z;
    xy += d.x * d.y, xz += d.x * d.z, yz += d.y * d.z;
  }
  const double mean = (xx + yy + zz) / 3;
  xx -= mean, yy -= mean, zz -= mean;
  const double spread = std::sqrt((xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz)) / 6);
  if (spread == 0) return 1;
  const double determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  const double angle = std::acos(std::clamp(determinant / (2 * spread * spread * spread), -1.0, 1.0)) / 3;
  const double third = 2 * std::acos(-1.0) / 3;
  return std::sqrt((mean + 2 * spread * std::cos(angle)) / (mean + 2 * spread * std::cos(angle + third)));
}

double meanRadius(const Shape& shape) {
  const Point centre = measureCentroid(shape);
  double sum = 0;
  for (const Point& p : shape) sum += norm(p - centre);
  return sum / static_cast<double>(shape.size());
}

double centreDistance(const Shape& a, const Shape& b) {
  return norm(measureCentroid(a) - measureCentroid(b));
}

/// The worst of several comparisons of one metric.
class Metric {
 public:
  Metric(const char* field, std::string tolerance, double allowed) : allowed_(allowed) {
    result_.check = std::string("bullet ") + field;
    result_.kind = "bullet";
    result_.field = field;
    result_.tolerance = std::move(tolerance);
    result_.share = -1;
  }

  /// What is off by a NaN is off for ever.
  void see(double expected, double actual, double off, const std::string& where) {
    const double share = off / allowed_;
    if (!(*result_.share <= share) && !std::isnan(share)) return;
    result_.share = share;
    result_.expected = formatReal(expected);
    result_.actual = formatReal(actual);
    result_.cell = where;
  }
  void seeRelative(double expected, double actual, const std::string& where) {
    see(expected, actual, std::abs(actual - expected) / std::abs(expected), where);
  }

  CheckResult result(std::uint64_t step) {
    result_.passed = *result_.share <= 1;
    if (result_.passed) return result_;
    result_.failureClass = "COMPUTATION";
    result_.firstStep = step;
    result_.message = "check.bullet." + result_.field + ": ours " + result_.actual + ", Bullet's " +
                      result_.expected + "; needs " + result_.tolerance + ", at step " +
                      std::to_string(step) + (result_.cell->empty() ? " of the egg" : " of " + *result_.cell);
    return result_;
  }

 private:
  double allowed_;
  CheckResult result_;
};

/// Indices of cells whose distance is looked at: of those that touch, or of all where none does.
std::vector<std::pair<std::size_t, std::size_t>> pairsOf(const World& world, bool& touching) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const auto& paths = world.cells.path;
  const auto place = [&](const CellPath& path) {
    return static_cast<std::size_t>(std::find(paths.begin(), paths.end(), path) - paths.begin());
  };
  for (const ContactMeasures& c : measureContacts(world)) pairs.push_back({place(c.a), place(c.b)});
  touching = !pairs.empty();
  if (touching) return pairs;
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (std::size_t j = i + 1; j < paths.size(); ++j) pairs.push_back({i, j});
  return pairs;
}

}  // namespace

std::vector<CheckResult> compareWithBullet(const World& ours, const std::vector<Shape>& shapes,
                                           const BulletCheck& check) {
  std::vector<Shape> own;
  std::vector<std::string> names;
  for (const CellPath& path : ours.cells.path) {
    own.push_back(cellVertices(ours, path));
    names.push_back(path.text());
  }
  std::vector<CheckResult> results;
  const auto relative = [](double tolerance) { return "rel " + formatReal(tolerance); };
  const auto eachCell = [&](const char* field, const std::optional<double>& tolerance, const auto& measure) {
    if (!tolerance) return;
    Metric metric(field, relative(*tolerance), *tolerance);
    for (std::size_t i = 0; i < own.size(); ++i)
      metric.seeRelative(measure(shapes[i]), measure(own[i]), names[i]);
    results.push_back(metric.result(ours.clock.step));
  };

  if (check.positions) {
    Metric metric("positions", "abs " + formatReal(*check.positions), *check.positions);
    for (std::size_t i = 0; i < own.size(); ++i)
      for (std::size_t v = 0; v < own[i].size(); ++v) {
        const double off = norm(own[i][v] - shapes[i][v]);
        metric.see(0, off, off, names[i]);
      }
    results.push_back(metric.result(ours.clock.step));
  }
  eachCell("radius", check.radius, meanRadius);
  eachCell("volume", check.volume,
           [&](const Shape& s) { return measureVolume(s, ours.model.mechanics->mesh.faces); });
  if (check.distance) {
    Metric metric("distance", relative(*check.distance), *check.distance);
    bool touching = false;
    for (const auto& [i, j] : pairsOf(ours, touching)) {
      const double gap = touching ? 2 * check.margin * ours.model.mechanics->physics.cell.radius : 0;
      metric.seeRelative(centreDistance(shapes[i], shapes[j]) - gap, centreDistance(own[i], own[j]),
                         names[i] + " and " + names[j]);
    }
    if (own.size() > 1) results.push_back(metric.result(ours.clock.step));
  }
  eachCell("aspect", check.aspect, aspect);
  return results;
}

}  // namespace morula
