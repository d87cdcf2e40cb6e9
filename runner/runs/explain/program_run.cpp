#include "explain/program_run.h"

#include "base/error.h"
#include "explain/hash_trace_json.h"
#include "simulation/checkpoint.h"
#include "simulation/world.h"
#include "system/child_process.h"

namespace morula {

ProgramRun::ProgramRun(std::string program, std::string scenario, std::function<World()> make,
                       std::vector<std::string> more)
    : program_(std::move(program)), scenario_(std::move(scenario)), make_(std::move(make)), more_(std::move(more)) {}

std::string ProgramRun::answer(const std::vector<std::string>& arguments) const {
  std::vector<std::string> command{program_, "trail", scenario_};
  command.insert(command.end(), arguments.begin(), arguments.end());
  command.insert(command.end(), more_.begin(), more_.end());
  ChildEnd end = runChild(command);
  if (end.notStarted()) throw InputError(program_ + ": cannot be started; give a Morula program");
  if (!end.well())
    throw InputError(program_ + ": ended with exit code " + std::to_string(end.code()) +
                     "; is it a Morula that knows `trail` and this scenario?");
  return std::move(end.said);
}

HashTrace ProgramRun::hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) {
  const std::string text =
      answer({"--from", std::to_string(from), "--to", std::to_string(to), "--every", std::to_string(every)});
  try {
    return readHashTrace(text);
  } catch (const InputError& e) { throw InputError(program_ + ": " + e.what()); }
}

std::unique_ptr<World> ProgramRun::stateAt(std::uint64_t step) {
  try {
    auto world = std::make_unique<World>(make_());
    restoreState(*world, answer({"--state", std::to_string(step)}));
    return world;
  } catch (const InputError& e) {  // failed there, or of another version or scene
    noState = e.what();
    return nullptr;
  }
}

}  // namespace morula
