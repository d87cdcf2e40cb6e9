#pragma once
// A scenario's organism for Python: it steps, records as the program does, and is measured, drawn, saved and restored.
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "library/morula.h"
#include "loop/run.h"
#include "loop/samples.h"
#include "observation/asked_measure.h"
#include "scenario/scenario.h"

namespace morula {

/// All that a scenario was read from: an organism can be made of it again, anywhere.
struct ScenarioSource {
  std::string bytes, name;
  std::vector<std::string> sets;  // as of `--set`
  std::vector<NamedFile> files;
};

/// The surfaces of all living cells, one after the other.
struct Surfaces {
  std::vector<double> vertices;         // x, y and z in turn [length]
  std::vector<std::int32_t> triangles;  // three vertices each, counted over all cells
  std::vector<std::int64_t> cell;       // [vertex] the number of its cell
  std::vector<std::int64_t> start;      // [cell] its first vertex; one more entry: the number of vertices
};

/// A measure of the organism is one value; of cells, one for each living cell by path. NaN: nothing to measure.
struct MeasuredNow {
  bool ofCells = false;
  std::vector<double> values;
};

class Organism {
 public:
  /// `source`: a file (also the database of a run), or a scenario's text. Throws InputError and FileError.
  Organism(const std::string& source, const std::vector<std::string>& sets, int threads);
  Organism(const ScenarioSource& source, int threads);

  /// Steps until the clock shows `time` [time], `most` steps are taken, or the scene ends. Throws NumericalError if the
  /// physics cannot go on, with the text that `morula run` prints, and at every later call.
  void run(double time, std::uint64_t most, const std::function<bool()>& stops);
  bool finished() const { return ended_.has_value(); }
  const World& world() const { return run_->world(); }
  std::string hash() const;

  /// Returns the state and all records so far as bytes. Throws InputError if the run has failed.
  std::string save() const;
  /// Goes back, or on, to a saved state of the same scenario and seed. Throws InputError for another one.
  void restore(const std::string& state);

  /// Returns a table of the database with its rows so far. Throws InputError for another name.
  DataTable table(const std::string& name) const;
  /// Returns the table of the world as it is now: "cell_sample", "contact", …
  DataTable tableNow(const std::string& name) const;
  MeasuredNow measure(const std::string& name) const;
  /// Returns the measure with its cells by path, under its name in tables. Throws InputError.
  AskedMeasure measureNamed(const std::string& name) const;
  Surfaces surfaces() const;
  /// Draws the organism, or without bodies the lineage, as the content of a PNG file. `colour`: as `--colour` of
  /// `morula render`; "": the scenario's colours, or clones where it has none. `size` [pixel].
  std::string picture(const std::string& colour, int size) const;

  const Scenario& scenario() const { return scenario_; }
  ScenarioSource source() const { return {scenario_.bytes, scenario_.file, sets_, scenario_.files}; }
  int threads() const { return execution_.threads; }

  std::atomic_flag inUse{};  // by a thread

 private:
  void begin();
  void end(const RunEnd& end);
  const RunResults& records() const { return ended_ ? *ended_ : samples_->recorder().records(); }
  const Observation& now() const;

  std::vector<std::string> sets_;
  Scenario scenario_;
  Execution execution_;
  std::optional<Samples> samples_;
  std::optional<Run> run_;
  std::optional<RunResults> ended_;  // all records, when the run has ended
  std::string failure_;
  mutable std::optional<Observation> now_;  // kept until the next step
};

}  // namespace morula
