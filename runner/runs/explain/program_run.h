#pragma once
// A run of another Morula, perhaps an older build, which is asked for its hashes and states.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "explain/run_source.h"

namespace morula {

class ProgramRun : public RunSource {
 public:
  /// `program` is started as `PROGRAM trail SCENARIO …`; `make` gives the scenario's world here, into which
  /// its states are restored. Both must know the same scenario file.
  ProgramRun(std::string program, std::string scenario, std::function<World()> make,
             std::vector<std::string> more = {});
  std::string name() const override { return program_; }
  /// Throws InputError if the program cannot be started or does not answer.
  HashTrace hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) override;
  /// Null if its states are of a form that is not known here.
  std::unique_ptr<World> stateAt(std::uint64_t step) override;

 private:
  std::string answer(const std::vector<std::string>& arguments) const;

  std::string program_, scenario_;
  std::function<World()> make_;
  std::vector<std::string> more_;  // further options of `trail`
};

}  // namespace morula
