#pragma once
// The simulator for other programs: a scene in; steps, measures and the state's hash out. The same scene gives the same
// bits as the program `morula` gives, on any machine.
//
//   find_package(Morula REQUIRED)
//   target_link_libraries(mine PRIVATE Morula::morula)
//
//   std::ifstream file("unique-four.scene");       // morula validate unique-four.yaml --scene unique-four.scene
//   morula::Simulator organism({std::istreambuf_iterator<char>(file), {}});
//   while (!organism.finished()) organism.step(64);
//   std::cout << organism.cells() << ' ' << organism.hash() << '\n';
//
// Errors are thrown as std::exception: a scene cannot be read or run, or the physics cannot go on. The organism then
// keeps the state in which it failed. Two simulators share nothing; only one thread at a time may use a simulator.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morula {

class Simulator {
 public:
  /// `scene`: the text that `morula validate --scene` writes. `threads`: their number changes no bit of any result.
  explicit Simulator(std::string_view scene, int threads = 1);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;

  /// Takes up to `most` time steps, not past the end. A thread must call step first: it sets the processor's rounding
  /// mode.
  void step(std::uint64_t most = 1);
  bool finished() const;
  std::uint64_t steps() const;
  double now() const;
  /// Returns the time at which the scene ends, if the scene gives one.
  std::optional<double> end() const;

  /// Returns 32 hexadecimal digits over the whole state, as `morula run` prints them.
  std::string hash() const;

  std::size_t cells() const;
  /// Returns the path of the living cell with this number: A or B for each division, "" for the egg. Cells are sorted
  /// by path.
  std::string path(std::size_t cell) const;
  /// Returns the substances that the cell holds, sorted, with blanks between.
  std::string substances(std::size_t cell) const;
  /// vertices: x, y and z of each vertex of the cell's surface in turn. faces: three vertices for each face. Both are
  /// empty without bodies.
  std::vector<double> vertices(std::size_t cell) const;
  std::vector<std::int32_t> faces(std::size_t cell) const;

  /// Takes a measure of the organism or of one cell, by its name in `morula schema --measures`; absent if there is
  /// nothing to measure.
  std::optional<double> measure(std::string_view name) const;
  std::optional<double> measure(std::string_view name, std::size_t cell) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace morula
