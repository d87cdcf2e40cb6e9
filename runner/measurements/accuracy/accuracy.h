#pragma once
// morula accuracy: speed against error. A scene is computed with many settings, each compared with a converged
// reference.
#include <optional>
#include <string>
#include <vector>

#include "accuracy/convergence.h"
#include "accuracy/mesh_error.h"
#include "accuracy/stated_errors.h"
#include "accuracy/trial.h"
#include "charts/chart.h"
#include "document/document.h"
#include "engines/measured_engine.h"

namespace morula {

struct AccuracyOptions {
  std::optional<double> until = {};          // [time] end of the comparison; absent: the horizon of chaos
  std::vector<Integrator> integrators = {};  // integrators to be compared
  std::vector<std::uint64_t> levels = {};    // levels of further meshes; the scene's own always takes part
  bool otherPrecision = true, otherLaw = true, cheaperModels = true;
  bool bullet = false;       // true: compare with Bullet, if Bullet can compute the scene
  std::string program = {};  // the program that runs Bullet: the running one's file
  int halvings = 4;          // number of halvings of the longest time step
  int samples = 16;          // max number of times at which the rows are compared
  int rounds = 3;            // number of repetitions of every run, for its CPU time
  double budget = 60;        // [s] max CPU time of the runs on other meshes
  bool brief = false;        // true: only the scenario's own settings, with a reference as fine as these need
  Execution execution = {};
  std::function<void(const std::string&)> tell = [](const std::string&) {};
};

/// The parts of a row's whole error. An absent part is unknown.
struct ErrorParts {
  std::optional<double> time;       // error of the time step: against the converged solution on the row's own mesh
  std::optional<double> mesh;       // error of the mesh: against finer meshes [MeshError]; spheres have none
  std::optional<double> precision;  // single against double precision; for doubles the grown rounding
  std::optional<double> model;      // error of another contact law, cell model or engine, with its time step
  /// Returns the sum of the known parts; if `mesh` is known it bounds the whole error.
  double sum() const;
};

struct AccuracyRow : Outcome {
  std::string series;
  MeasuredEngine engine = MeasuredEngine::morula;
  std::vector<std::string> set;  // changes for --set that give a scenario of the scene this setting
  // Largest errors before `partedAt`, against the reference on the scenario's mesh
  std::optional<double> error;  // the largest of centroid, volume and surface in `errors`
  ErrorParts parts;
  std::optional<DividedElsewhere> cut;  // the first division whose plane differs from the reference's
  StateError errors;
  double until = 0;                // [time] the last comparison in the errors
  bool touch = false;              // true: cells of the reference touch by then
  double birthTimes = 0;           // [cycle lengths] largest difference of births
  std::optional<double> partedAt;  // [time] first comparison at which other cells lived
  bool resolved = false;           // true: the reference's error is at most a tenth of this one
};

/// The reference of all rows: the scenario's own mesh in time steps that no longer matter. `witness`: the same scene by
/// another integrator, which confirms it.
struct AccuracyReference {
  Setting setting, witness;
  LeftError left, witnessLeft;  // Richardson's estimates; `left` is at least the effect of rounding
  double distance = 0;          // distance of reference and witness
  bool agrees = false;          // true: the distance is within their estimates
};

struct SeriesOrder {
  std::string series;
  double theory = 0;  // the order for a smooth scene
  std::optional<PowerLaw> observed;
};

struct SpeedAtError {
  double error = 0;
  std::string series;
  double cpuSeconds = 0, forceEvaluations = 0;
  std::optional<double> speed;  // CPU time of the scenario's own settings at this error, over `cpuSeconds`
};

/// The least CPU time for an error, of Morula's settings and of Bullet's, if both reach it.
struct BulletSpeed {
  double error = 0;
  std::string ours, bullets;  // names of the series
  double ourSeconds = 0, bulletSeconds = 0;
  double bulletMostSeconds = 0;  // CPU time of the slowest of Bullet's series that reach the error
};

/// The cheapest of the tried settings that are as exact as the scenario's own.
struct Rival {
  std::string series;
  double cpuSeconds = 0;
  double speed = 0;  // the scenario's CPU time over `cpuSeconds`
};

struct AccuracyReport {
  std::string scenario, usual;  // `usual`: the series of the scenario's own settings
  AccuracyRow own;              // the row of the scenario's own settings
  std::optional<Rival> rival;   // absent: no tried setting is as exact, or the own row has failed
  MeshError mesh;               // error of the scenario's own mesh
  StatedErrors stated;          // errors of the scenario's own settings, at more times than those of rows
  std::vector<double> times;    // [time] times at which rows are compared
  std::optional<double> end;    // [time] planned end of the scene; absent: not planned
  std::optional<Horizon> horizon;
  AccuracyReference reference;
  std::vector<AccuracyRow> rows;
  std::vector<SeriesOrder> orders;
  std::vector<SpeedAtError> speeds;
  std::vector<BulletSpeed> bulletSpeeds;  // at errors of 1e-1, 1e-2, …
  std::vector<std::string> remarks;
};

/// Throws InputError for a scene that has no error of a time step.
void refuseWithoutError(const Scenario& scenario);
/// Measures errors and costs. Throws InputError for such scenes, or if the scene's own settings cannot run.
AccuracyReport measureAccuracy(const ReadScenario& read, const AccuracyOptions& options);

/// Measures how far from rest each settling of a quasi-static scene ends. It runs the scene to its end, and settles
/// each time further, to a hundredth of the tolerance (SettlingRecord). Throws InputError for a scene that cannot run
/// to its end.
Table measureSettlings(Scenario scenario, const Execution& how);

/// Returns the rows of Morula, or of Bullet, by CPU time, whose error on the scenario's mesh plus the reference's own
/// is at most `target`.
std::vector<const AccuracyRow*> thatHold(const AccuracyReport& report, double target, bool ours = true);

/// Returns the cheapest run as exact as `own`, perhaps interpolated between neighbours of a series.
std::optional<Rival> findRival(const AccuracyRow& own, const std::vector<AccuracyRow>& rows);

std::vector<BulletSpeed> compareSpeeds(const std::vector<AccuracyRow>& rows);

/// Orders and speeds of rows, without rows that are not resolved, parted or failed.
std::vector<SeriesOrder> findOrders(const std::vector<AccuracyRow>& rows);
std::vector<SpeedAtError> findSpeeds(const std::vector<AccuracyRow>& rows, const std::string& usual);

/// Describes the report for people.
Document describe(const AccuracyReport& report);

/// Returns a time step as "1/128", or as a number; a scene's own choice of steps as a share of them.
std::string stepText(double timeStep);
std::string stepText(const Setting& setting);
/// Returns tables of all settings with the parts of their errors, and of the failed settings with their reasons.
Document settingTables(const AccuracyReport& report);
/// Returns the order in which each series' errors fall with the time step.
Table orderTable(const AccuracyReport& report);
/// Returns the least CPU times for errors, Morula's and Bullet's.
Table bulletTable(const AccuracyReport& report);

/// Writes a report for other programs. `picture`: the path of its chart.
Json toJson(const AccuracyReport& report, const std::string& picture);
Json toJson(const Setting& setting);

/// Reads a report back, as far as people see it. Throws for other JSON.
AccuracyReport accuracyFrom(const Json& json);
/// Returns all rows as CSV, for other programs.
std::string accuracyCsv(const Json& rows);

/// Draws error over CPU time, both on logarithmic scales: a line for each series, with its time steps as labels. Failed
/// and unresolved runs are left out. A run in which other cells live from some time on is a separate hollow point, with
/// that time.
Drawing drawAccuracy(const AccuracyReport& report);
/// Returns the series of Bullet that are not drawn, if it has many: other series of Bullet's are better in error and
/// time.
std::vector<std::string> beatenBullets(const AccuracyReport& report);

}  // namespace morula
