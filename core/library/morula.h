#pragma once
// The simulator for other programs: a scene in; steps, tables, measures and the state's hash out. The same scene gives
// the same bits as the program `morula` gives, on any machine.
//
//   find_package(Morula REQUIRED)                         // Morula::morula, and Morula::scenarios for scenario.h
//   target_link_libraries(mine PRIVATE Morula::scenarios)
//
//   morula::Simulator organism(morula::readScenario("unique-four.yaml", {"physics.drag=5"}).scene);  // scenario.h
//   while (!organism.finished()) organism.step(64);
//   std::cout << organism.cells() << ' ' << organism.hash() << '\n';
//
// Errors (base/error.h): InputError if a scene or a question is wrong, NumericalError if the physics cannot go on. The
// organism then keeps the state in which it failed. Two simulators share nothing; one thread at a time may use a
// simulator. The caller's rounding mode is given back.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace morula {

/// A column has one entry for each row: in `numbers` (NaN: absent) or, of texts and bytes, in `texts`.
struct DataColumn {
  enum class Kind { real, whole, text, bytes };
  std::string name, unit, meaning;  // unit: "length³"; "" for pure numbers, texts and bytes
  Kind kind = Kind::real;
  std::vector<double> numbers;
  std::vector<std::optional<std::string>> texts;
};
struct DataTable {
  std::string name;
  std::vector<DataColumn> columns;
};

struct MeasureInfo {
  std::string name, unit, meaning;
  bool ofCells = false;  // of each cell; otherwise of the organism
};

class Simulator {
 public:
  /// `scene`: the text that readScenario or `morula validate --scene` gives. `threads`: changes no bit of any result.
  explicit Simulator(std::string_view scene, int threads = 1);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;

  /// Takes up to `most` time steps, not past the end.
  void step(std::uint64_t most = 1);
  /// Steps until the clock shows `time` [time] or later, or the scene ends.
  void runUntil(double time);
  bool finished() const;
  std::uint64_t steps() const;
  double now() const;
  /// Returns the time at which the scene ends, if the scene gives one.
  std::optional<double> end() const;

  /// Returns 32 hexadecimal digits over the whole state, as `morula run` prints them.
  std::string hash() const;
  /// Returns the state as bytes; a simulator of the same scene that restores them goes on with the same bits.
  std::string save() const;
  void restore(std::string_view state);

  std::size_t cells() const;
  /// Returns the path of the living cell with this number: A or B for each division, "" for the egg. Cells are sorted
  /// by path.
  std::string path(std::size_t cell) const;
  /// Returns the substances that the cell holds, sorted, with blanks between.
  std::string substances(std::size_t cell) const;
  /// vertices: x, y and z of each vertex of the cell's surface in turn [length]. faces: three vertices for each face.
  /// Both are empty without bodies.
  std::vector<double> vertices(std::size_t cell) const;
  std::vector<std::int32_t> faces(std::size_t cell) const;

  /// Returns a table with the columns of the database: "cell" (the lineage so far), "cell_sample" and "contact" (living
  /// cells with bodies now), "sample" (the organism now), "connection", "division", "time_step", "settling" or
  /// "experiment".
  DataTable table(std::string_view name) const;
  /// Takes a measure of the organism, of one cell or of all living cells (NaN: absent), by its name in measures();
  /// absent if there is nothing to measure. All cells are measured once and kept until the next step.
  std::optional<double> measure(std::string_view name) const;
  std::optional<double> measure(std::string_view name, std::size_t cell) const;
  std::vector<double> column(std::string_view name) const;
  static std::vector<MeasureInfo> measures();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace morula
