#pragma once
// morula accuracy: speed against error. One scene, computed in many ways, each held against a reference that
// has converged by itself.
#include <optional>
#include <string>
#include <vector>

#include "accuracy/convergence.h"
#include "accuracy/mesh_error.h"
#include "accuracy/trial.h"
#include "charts/chart.h"
#include "document/document.h"

namespace morula {

struct AccuracyOptions {
  std::optional<double> until = {};          // [time] compare up to here; absent: up to the horizon of chaos
  std::vector<Integrator> integrators = {};  // to be compared
  std::vector<std::uint64_t> levels = {};    // further meshes; the scene's own always takes part
  bool otherPrecision = true, otherLaw = true, cheaperModels = true;
  bool bullet = false;       // compare with Bullet, where it can compute the scene
  std::string program = {};  // that is asked: this one's own file
  int halvings = 4;          // of the longest time step
  int samples = 16;          // times of comparison, at most
  int rounds = 3;            // of every run, for the CPU time
  double budget = 60;        // [s] of CPU time, for the runs on other meshes
  bool brief = false;        // only the scenario as it is; the reference then is as fine as that asks for
  Execution execution = {};
  std::function<void(const std::string&)> tell = [](const std::string&) {};
};

/// The parts of a row's whole error. Absent: not known.
struct ErrorParts {
  std::optional<double> time;       // of the time step: against the converged solution on the row's own mesh
  std::optional<double> mesh;       // of the mesh: against finer ones [MeshError]; spheres have none
  std::optional<double> precision;  // single against double; of doubles what rounding has grown to
  std::optional<double> model;      // another contact law, cell model or engine, its time step included
  /// The sum of what is known; the whole error is no larger if its mesh is known.
  double sum() const;
};

struct AccuracyRow : Outcome {
  std::string series, engine = "morula";
  std::vector<std::string> set;  // makes a scenario of the scene compute so, as --set takes it
  // Up to `partedAt`, the largest of all times of comparison, against the reference on the scenario's mesh
  std::optional<double> error;  // the largest of the three in `errors`
  ErrorParts parts;
  std::optional<DividedElsewhere> cut;  // the first division whose plane is another than the reference's
  StateError errors;
  double until = 0;                // [time] of the last comparison in them
  bool touch = false;              // whether cells of the reference do by then
  double birthTimes = 0;           // [cycle lengths] largest difference of births
  std::optional<double> partedAt;  // [time] first comparison at which other cells lived
  bool resolved = false;           // whether the reference is ten times as good at least
};

/// The reference of all rows: the scenario's own mesh in time steps that no longer matter. `witness`: the same
/// by another integrator, which confirms it.
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

/// The settings that are as exact as the scenario is and cost the least among those tried.
struct Rival {
  std::string series;
  double cpuSeconds = 0;
  double speed = 0;  // the scenario's CPU time over this
};

struct AccuracyReport {
  std::string scenario, usual;  // the series of the scenario's own settings
  AccuracyRow own;              // the scenario as it is
  std::optional<Rival> rival;   // nothing that was tried is as exact, or it has failed
  MeshError mesh;               // of the scenario's own mesh
  std::vector<double> times;    // [time] of comparison
  std::optional<double> end;    // [time] of the scene, where it is planned
  std::optional<Horizon> horizon;
  AccuracyReference reference;
  std::vector<AccuracyRow> rows;
  std::vector<SeriesOrder> orders;
  std::vector<SpeedAtError> speeds;
  std::vector<BulletSpeed> bulletSpeeds;  // at 1e-1, 1e-2, …
  std::vector<std::string> remarks;
};

/// Throws InputError for a scene that has no error of a time step.
void refuseWithoutError(const Scenario& scenario);
/// Throws InputError for such a scene, or one whose own settings cannot run.
AccuracyReport measureAccuracy(const ReadScenario& read, const AccuracyOptions& options);

/// How far from rest each settling of a quasi-static scene ends: runs it to its end, and from each settling once more
/// until the residual is a hundredth of the tolerance (SettlingRecord). Throws InputError for a scene that cannot run
/// to its end.
Table measureSettlings(Scenario scenario, const Execution& how);

/// The rows of ours, or of Bullet's, whose error on the scenario's mesh, with the reference's own added, is no more
/// than `target`, by CPU time.
std::vector<const AccuracyRow*> thatHold(const AccuracyReport& report, double target, bool ours = true);

/// Between neighbouring runs of a series, or one that is more exact and not dearer.
std::optional<Rival> findRival(const AccuracyRow& own, const std::vector<AccuracyRow>& rows);

std::vector<BulletSpeed> compareSpeeds(const std::vector<AccuracyRow>& rows);

/// Orders and speeds of rows; those not resolved, parted or failed are left out.
std::vector<SeriesOrder> findOrders(const std::vector<AccuracyRow>& rows);
std::vector<SpeedAtError> findSpeeds(const std::vector<AccuracyRow>& rows, const std::string& usual);

/// Describes the report for people.
Document describe(const AccuracyReport& report);

/// "1/128", or as a number; of steps that the scene chooses a share of them.
std::string stepText(double timeStep);
std::string stepText(const Setting& setting);
/// Every setting, and what its error is made of; below it those that failed with their reasons.
Document settingTables(const AccuracyReport& report);
/// How fast errors fall with the time step.
Table orderTable(const AccuracyReport& report);
/// The least CPU time for an error, ours and Bullet's.
Table bulletTable(const AccuracyReport& report);

/// Writes a report for other programs. `picture`: its path.
Json toJson(const AccuracyReport& report, const std::string& picture);
Json toJson(const Setting& setting);

/// Reads a report back as far as people are shown it. Throws for other JSON.
AccuracyReport accuracyFrom(const Json& json);
/// All rows for other programs, CSV.
std::string accuracyCsv(const Json& rows);

/// Draws error over CPU time, both on logarithmic scales, one line per series, each point labelled with
/// its time step; what failed or is not resolved is not drawn. A run in which other cells live from some time
/// on is a hollow point by itself, with that time.
Drawing drawAccuracy(const AccuracyReport& report);
/// If Bullet has many series, returns those that are not drawn: others of its own beat them in error and time.
std::vector<std::string> beatenBullets(const AccuracyReport& report);

}  // namespace morula
