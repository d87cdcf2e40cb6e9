#pragma once
// The measures of a World: one row for each measure of the world, of a cell, and of a pair of cells that touch. Columns
// of the database, values of goldens, JSON, a scenario's checks and scenarios/MEASURES.md come from these rows; a new
// measure is a new row. Measures are taken on demand only: nothing is computed unless it is asked for.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "observation/observation.h"

namespace morula {

/// Two cells that touch, a < b.
struct Touch {
  const CellContext &a, &b;
  double area;                       // [length²] as ContactArea
  std::optional<double> duration{};  // [time] as Observation::contactDurations; absent: not known
};

/// The part that a scene must have for a measure.
enum class Needs { nothing, bodies, contact, shell, referenceContacts, referencePositions };
const char* name(Needs needs);

/// Returns true if the world of the observation has the part, and the observation a reference that is needed.
bool canMeasure(const Observation& now, Needs needs);

enum class Taken {
  withSamples,  // at every sample
  onDemand,     // where a check or a scenario's record asks for it
};

template <class Of>
struct Measure {
  const char* name;       // of the column, in goldens and in JSON
  const char* unit = "";  // "length³"; "": a pure number
  const char* meaning;    // its definition, with its source; one line
  Needs needs = Needs::bodies;
  Taken taken = Taken::withSamples;
  bool isWhole = false;        // a whole number
  bool followsNumber = false;  // changes with the number of cells, or with how small they are, all else alike
  std::optional<double> (*get)(const Of&);  // absent: there is nothing to measure
  /// Takes the measure of clones of cells that are `depth` divisions from the egg; null for measures that are not of
  /// clones.
  std::optional<double> (*ofClones)(const Of&, int depth) = nullptr;
};
using WorldMeasure = Measure<Observation>;
using CellMeasure = Measure<CellContext>;
using PairMeasure = Measure<Touch>;

/// Returns all rows of one table: `Of` is Observation, CellContext or Touch. Rows taken with samples stand first.
template <class Of>
std::span<const Measure<Of>> measures();
template <>
std::span<const WorldMeasure> measures<Observation>();
template <>
std::span<const CellMeasure> measures<CellContext>();
template <>
std::span<const PairMeasure> measures<Touch>();
/// Returns the measures that every sample takes.
template <class Of>
std::span<const Measure<Of>> sampledMeasures();
/// Returns the row of this name. Throws BugError if there is none.
template <class Of>
const Measure<Of>& measure(std::string_view name);

/// The values of one thing, one for each of sampledMeasures<Of>(); absent: not measured.
template <class Of>
class Measured {
 public:
  std::vector<std::optional<double>> values = std::vector<std::optional<double>>(sampledMeasures<Of>().size());

  std::optional<double>& operator[](std::string_view name) { return values[indexOf(name)]; }
  const std::optional<double>& operator[](std::string_view name) const { return values[indexOf(name)]; }
  /// Returns a value that has been measured. Throws BugError if it has not.
  double at(std::string_view name) const;
  /// Returns the size [byte] of the values.
  static std::size_t bytes() { return sampledMeasures<Of>().size() * sizeof(std::optional<double>); }
  friend bool operator==(const Measured&, const Measured&) = default;

 private:
  static std::size_t indexOf(std::string_view name);
};

/// One living cell's geometry. Lineage-only worlds have none.
struct CellMeasures : Measured<CellContext> {
  CellPath path;
  StateId state = 0;
};

struct ContactMeasures : Measured<Touch> {
  CellPath a, b;  // a < b
};

struct WorldMeasures : Measured<Observation> {
  double time = 0;  // [time]
  std::uint64_t step = 0;
};

WorldMeasures measureWorld(const Observation& now);
/// Measures all cells, sorted by lineage path; empty in a lineage-only world.
std::vector<CellMeasures> measureCells(const Observation& now);
/// Measures all contacts, sorted by (a, b); empty without contact.
std::vector<ContactMeasures> measureContacts(const Observation& now);

/// The thing that a measure is taken of. Names of measures on demand are unique over all scopes.
enum class Scope { world, cell, pair };
const char* name(Scope scope);

struct MeasureOnDemand {
  Scope scope;
  const char* name;
  Needs needs;
};
/// Returns all rows on demand, of all tables.
std::vector<MeasureOnDemand> measuresOnDemand();

/// One value of a measure on demand.
struct TakenMeasure {
  Scope scope;
  std::string name;  // as it was asked for
  CellPath a, b;     // cell: a; pair: a < b
  double value;
  friend bool operator==(const TakenMeasure&, const TakenMeasure&) = default;
};
/// Returns the values of the measures with these names [asked_measure.h]: of the world in the order of names,
/// then cell by cell and pair by pair, by path. A measure with nothing to measure has no value.
std::vector<TakenMeasure> takeMeasures(const Observation& now, std::span<const std::string> names);

inline WorldMeasures measureWorld(const World& world) { return measureWorld(Observation(world)); }
inline std::vector<CellMeasures> measureCells(const World& world) { return measureCells(Observation(world)); }
inline std::vector<ContactMeasures> measureContacts(const World& world) { return measureContacts(Observation(world)); }

/// Returns the surface of one living cell: vertex positions, in the order of its mesh, and faces. Empty if no such cell
/// lives, or without bodies.
Mesh cellMesh(const World& world, const CellPath& path);
/// Returns the vertices of cellMesh alone.
std::vector<Point> cellVertices(const World& world, const CellPath& path);

}  // namespace morula
