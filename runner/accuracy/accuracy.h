#pragma once
// morula accuracy: speed against error. One scene, computed in many ways, each held against a reference that
// has converged by itself.
#include <optional>
#include <string>
#include <vector>

#include "accuracy/convergence.h"
#include "accuracy/trial.h"

namespace morula {

struct AccuracyOptions {
  std::optional<double> until;          // [time] compare up to here; absent: up to the horizon of chaos
  std::vector<Integrator> integrators;  // to be compared
  std::vector<std::uint64_t> levels;    // further meshes; the scene's own always takes part
  bool otherPrecision = true, otherLaw = true, cheaperModels = true;
  bool bullet = false;  // beside Bullet, where it can be asked
  std::string program;  // that is asked: this one's own file
  int halvings = 4;     // of the longest time step
  int samples = 16;     // times of comparison, at most
  int rounds = 3;       // of every run, for the CPU time
  Execution execution;
  std::function<void(const std::string&)> tell = [](const std::string&) {};
};

struct AccuracyRow {
  Setting setting;
  std::string series, engine = "morula";
  std::string failure;  // "": it ran to the end
  // Up to `partedAt`, the largest of all times of comparison
  std::optional<double> error;  // the largest of the three in `errors`
  StateError errors;
  double birthTimes = 0;           // [cycle lengths] largest difference of births
  std::optional<double> partedAt;  // [time] first comparison at which other cells lived
  bool resolved = false;           // whether the reference is ten times as good at least
  double cpuSeconds = 0;
  std::uint64_t steps = 0, forceEvaluations = 0, vertexSteps = 0;
};

/// What all rows are held against.
struct AccuracyReference {
  Setting setting, witness;
  LeftError left, witnessLeft;  // by Richardson's estimate; the reference's at least what rounding makes
  double distance = 0;          // of the two
  bool agrees = false;          // the two are no farther apart than their estimates allow
};

struct SeriesOrder {
  std::string series;
  double theory = 0;  // for a smooth scene
  std::optional<PowerLaw> observed;
};

struct SpeedAtError {
  double error = 0;
  std::string series;
  double cpuSeconds = 0, forceEvaluations = 0;
  std::optional<double> speed;  // CPU time of the scenario's own settings at that error over this
};

/// The least CPU time for an error, of our settings and of Bullet's, where both have it.
struct BulletSpeed {
  double error = 0;
  std::string ours, bullets;  // series
  double ourSeconds = 0, bulletSeconds = 0;
  double bulletMostSeconds = 0;  // of its series that have that error, the slowest
};

/// Of the settings tried, those that are as exact as the scenario is and cost the least.
struct Rival {
  std::string series;
  double cpuSeconds = 0;
  double speed = 0;  // the scenario's CPU time over this
};

struct AccuracyReport {
  std::string scenario, usual;  // the series of the scenario's own settings
  AccuracyRow own;              // the scenario as it is
  std::optional<Rival> rival;   // nothing that was tried is as exact, or it has failed
  std::vector<double> times;    // [time] of comparison
  std::optional<Horizon> horizon;
  AccuracyReference reference;
  std::vector<AccuracyRow> rows;
  std::vector<SeriesOrder> orders;
  std::vector<SpeedAtError> speeds;
  std::vector<BulletSpeed> bulletSpeeds;  // at 1e-1, 1e-2, …
  std::vector<std::string> remarks;
};

/// Throws InputError for a scene without bodies, or whose own settings cannot run.
AccuracyReport measureAccuracy(const ReadScenario& read, const AccuracyOptions& options);

/// The row with the least CPU time whose error, with the reference's own added, is no more than `target`;
/// null if none has.
const AccuracyRow* cheapest(const AccuracyReport& report, double target);

/// Between neighbouring runs of a series, or one that is more exact and not dearer.
std::optional<Rival> findRival(const AccuracyRow& own, const std::vector<AccuracyRow>& rows);

std::vector<BulletSpeed> compareSpeeds(const std::vector<AccuracyRow>& rows);

/// Orders and speeds of rows; those not resolved, parted or failed are left out.
std::vector<SeriesOrder> findOrders(const std::vector<AccuracyRow>& rows);
std::vector<SpeedAtError> findSpeeds(const std::vector<AccuracyRow>& rows, const std::string& usual);

}  // namespace morula
