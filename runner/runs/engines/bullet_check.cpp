// Metrics for a fair comparison of two engines.
#include "engines/bullet_check.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "base/error.h"
#include "engines/bullet_scene.h"
#include "engines/engine_comparison.h"
#include "engines/engine_worker.h"
#include "mesh/mesh_measures.h"
#include "observation/measures.h"
#include "system/child_process.h"
#include "yaml/numbers.h"

namespace morula {
namespace {

constexpr const char* skipped = "not checked: this build has no Bullet";

CheckResult about(FailureClass failureClass, const std::string& text) {
  return judged({.check = "bullet", .kind = CheckKind::bullet, .expected = "an answer", .actual = text}, false,
                "bullet: " + text, failureClass);
}

/// Returns true for the two integrators that Bullet's step can compute (BulletScene::physics).
bool isVerlet(Integrator integrator) {
  return integrator == Integrator::thesisVerlet || integrator == Integrator::velocityVerlet;
}

using Shape = std::vector<Point>;

/// Returns √(largest/smallest second moment about the centre): 1 for a sphere, a/c for an ellipsoid.
double aspect(const Shape& shape) {
  const Point centre = measureCentroid(shape);
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Point& p : shape) {
    const Eigen::Vector3d d(p.x - centre.x, p.y - centre.y, p.z - centre.z);
    moments += d * d.transpose();
  }
  const auto values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments, Eigen::EigenvaluesOnly).eigenvalues();
  return values[2] == 0 ? 1 : std::sqrt(values[2] / values[0]);
}

double radiusOf(const Shape& shape) {
  const Point centre = measureCentroid(shape);
  double sum = 0;
  for (const Point& p : shape) sum += norm(p - centre);
  return sum / static_cast<double>(shape.size());
}

double centreDistance(const Shape& a, const Shape& b) { return norm(measureCentroid(a) - measureCentroid(b)); }

/// The largest deviation in one metric.
class Metric {
 public:
  Metric(const char* field, std::string tolerance, double allowed)
      : allowed_(allowed),
        result_{.check = std::string("bullet ") + field,
                .kind = CheckKind::bullet,
                .tolerance = std::move(tolerance),
                .field = field,
                .share = -1} {}

  /// Keeps the largest deviation. A NaN stays, whatever follows.
  void see(double expected, double actual, double off, const std::string& where) {
    const double share = off / allowed_;
    if (!(*result_.share <= share) && !std::isnan(share)) return;
    result_.share = share;
    result_.expected = exactText(expected);
    result_.actual = exactText(actual);
    result_.cell = where;
  }
  void seeRelative(double expected, double actual, const std::string& where) {
    see(expected, actual, std::abs(actual - expected) / std::abs(expected), where);
  }

  CheckResult result(std::uint64_t step) const {
    CheckResult r = judged(result_, *result_.share <= 1,
                           "check.bullet." + result_.field + ": ours " + result_.actual + ", Bullet's " +
                               result_.expected + "; needs " + result_.tolerance + ", at step " + std::to_string(step) +
                               " of " + cellName(result_.cell.value_or("")));
    if (!r.passed) r.firstStep = step;
    return r;
  }

 private:
  double allowed_;
  CheckResult result_;
};

/// Returns pairs of cells whose distances are compared: cells that touch, or all pairs if none touch.
std::vector<std::pair<std::size_t, std::size_t>> pairsOf(const World& world, bool& touching) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const auto place = [&](const CellPath& path) { return static_cast<std::size_t>(cellNumber(world.cells, path)); };
  for (const ContactMeasures& c : measureContacts(world)) pairs.push_back({place(c.a), place(c.b)});
  touching = !pairs.empty();
  if (touching) return pairs;
  for (std::size_t i = 0; i < world.cells.path.size(); ++i)
    for (std::size_t j = i + 1; j < world.cells.path.size(); ++j) pairs.push_back({i, j});
  return pairs;
}

}  // namespace

bool wasSkipped(const CheckResult& result) { return result.kind == CheckKind::bullet && result.expected == skipped; }

BulletCheck tolerancesFor(const Scenario& scenario) {
  BulletCheck check = *scenario.check.bullet;
  if (check.hasTolerances()) return check;
  const MechanicsScene& mechanics = *scenario.scene.mechanics;
  if (mechanics.contact && scenario.scene.cells.size() > 1) {
    check.distance = 0.01, check.volume = 0.001, check.aspect = 0.02;
  } else if (check.baseline == Baseline::b1 && isVerlet(mechanics.physics.integrator)) {
    check.positions = 1e-10 * mechanics.physics.cell.radius;
  } else {
    check.radius = check.volume = check.baseline == Baseline::b3 ? 1e-8 : 1e-6;
  }
  return check;
}

BulletFindings checkAgainstBullet(const Scenario& scenario, const World& end, bool quiet,
                                  const std::vector<double>& frameTimes) {
  if (!scenario.check.bullet) return {};
  if (!bulletIsAvailable())
    return {{{.check = "bullet", .kind = CheckKind::bullet, .expected = skipped, .actual = skipped}}, {}};
  const BulletCheck check = tolerancesFor(scenario);
  tell("the same in Bullet, " + std::string(name(check.baseline)), quiet);
  ExternalRun bullet;
  try {
    bullet = runExternally(scenario,
                           {.engine = engineOf(check.baseline),
                            .margin = check.margin,
                            .integrator = scenario.scene.mechanics->physics.integrator,
                            .frameTimes = frameTimes},
                           ownProgram());
  } catch (const FileError& error) { return {{about(FailureClass::setup, error.what())}, {}}; }
  const bool silent = bullet.end == ExternalRun::End::silent;
  if (bullet.end != ExternalRun::End::done)
    return {{about(silent ? FailureClass::setup : FailureClass::computation, judge({}, bullet).text)}, {}};
  if (bullet.step != end.clock.step || bullet.shapes.size() != end.cells.path.size())
    return {{about(FailureClass::computation, "came to another end: step " + std::to_string(bullet.step) + ", ours " +
                                                  std::to_string(end.clock.step))},
            {}};
  return {compareWithBullet(end, bullet.shapes, check), bullet};
}

std::vector<CheckResult> compareWithBullet(const World& ours, const std::vector<Shape>& shapes,
                                           const BulletCheck& check) {
  const std::vector<Shape> own = shapesOf(ours);
  const auto nameOf = [&](std::size_t cell) { return ours.cells.path[cell].text(); };
  std::vector<CheckResult> results;
  const auto relative = [](double tolerance) { return "rel " + exactText(tolerance); };
  const auto eachCell = [&](const char* field, const std::optional<double>& tolerance, const auto& measure) {
    if (!tolerance) return;
    Metric metric(field, relative(*tolerance), *tolerance);
    for (std::size_t i = 0; i < own.size(); ++i) metric.seeRelative(measure(shapes[i]), measure(own[i]), nameOf(i));
    results.push_back(metric.result(ours.clock.step));
  };

  if (check.positions) {
    Metric metric("positions", "abs " + exactText(*check.positions), *check.positions);
    for (std::size_t i = 0; i < own.size(); ++i) {
      const std::string name = nameOf(i);
      for (std::size_t v = 0; v < own[i].size(); ++v) {
        const double off = norm(own[i][v] - shapes[i][v]);
        metric.see(0, off, off, name);
      }
    }
    results.push_back(metric.result(ours.clock.step));
  }
  eachCell("radius", check.radius, radiusOf);
  eachCell("volume", check.volume, [&](const Shape& s) { return measureVolume(s, ours.model.mechanics->mesh.faces); });
  if (check.distance) {
    Metric metric("distance", relative(*check.distance), *check.distance);
    bool touching = false;
    for (const auto& [i, j] : pairsOf(ours, touching)) {
      const double gap = touching ? 2 * check.margin * ours.model.mechanics->physics.cell.radius : 0;
      metric.seeRelative(centreDistance(shapes[i], shapes[j]) - gap, centreDistance(own[i], own[j]),
                         nameOf(i) + " and " + nameOf(j));
    }
    if (own.size() > 1) results.push_back(metric.result(ours.clock.step));
  }
  eachCell("aspect", check.aspect, aspect);
  return results;
}

}  // namespace morula
