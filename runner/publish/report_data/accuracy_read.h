#pragma once
// What morula accuracy --json has printed, read back as far as a page shows it.
#include <optional>
#include <string>
#include <vector>

#include "system/json.h"

namespace morula {

/// One way to compute the scene, held against the reference. Errors in radii of the egg, of volumes relative; absent: not known.
struct AccuracyEntry {
  std::string series, engine;    // engine: "morula", "bullet-b1", …
  double timeStep = 0;           // [time]
  std::vector<std::string> set;  // as --set takes them
  std::optional<double> whole;  // no more than the sum of its parts; at least that where the mesh's is absent
  std::optional<double> time, mesh, precision, model;
  std::optional<double> onMesh;    // against the reference, on the scenario's mesh
  std::optional<double> partedAt;  // [time] other cells live from then on
  bool resolved = false;           // ten times the reference's own error at least
  bool cutElsewhere = false;       // a cell divides across another plane
  double cpuSeconds = 0;
  std::uint64_t evaluations = 0, steps = 0;
  std::string failure;  // "": it has come to its end

  bool isOurs() const { return engine == "morula"; }
  /// Compared, and with the reference's own error no farther off than that.
  bool holds(double error, double referenceError) const;
};

struct AccuracyMeshLevel {
  int icosphere = 0;
  double error = 0, position = 0, volume = 0, surface = 0, pressure = 0,
         contactArea = 0;  // largest of all times
};

struct AccuracyRead {
  std::string scenario, file;  // file: "" where it is not told
  double until = 0;            // [time]
  std::optional<double> end;   // [time] of the scene
  struct {
    std::string integrator, witness;
    double timeStep = 0, witnessTimeStep = 0, order = 0;
    std::optional<double> error, witnessDistance, witnessError;
    bool agrees = false;
  } reference;
  struct {
    std::optional<double> error;
    std::string unknown, limit;  // why; ""
    std::optional<int> icosphere;
    double order = 0;
    bool orderIsObserved = false;
    std::optional<double> partedAt;
    std::vector<AccuracyMeshLevel> levels;
  } mesh;
  AccuracyEntry own;  // the scenario as it is
  std::string rival;  // the cheapest series as exact as that; "": none
  double rivalSpeed = 0;
  std::vector<AccuracyEntry> rows;
  struct Order {
    std::string series;
    double theory = 0, standardError = 0;
    std::optional<double> observed;
    int points = 0;
  };
  std::vector<Order> orders;
  struct BulletSpeed {
    double error = 0, ours = 0, bullets = 0, slowest = 0;  // [s]
    std::string series, bulletSeries;
  };
  std::vector<BulletSpeed> besideBullet;
  std::vector<std::string> remarks;
  std::vector<std::pair<std::string, std::string>> provenance;  // name, value; none where it is not told
  Json target;                                                  // null without --target

  double referenceError() const { return reference.error.value_or(0); }
};

/// Throws Json::exception for other JSON.
AccuracyRead accuracyFrom(const Json& json);

/// All rows for other programs, CSV [RFC 4180].
std::string accuracyCsv(const Json& rows);

/// The row with the least CPU time that holds the error: of ours, or of Bullet's. Null: none does.
const AccuracyEntry* cheapestFor(const AccuracyRead& read, double error, bool ours);

}  // namespace morula
