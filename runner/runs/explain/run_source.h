#pragma once
// Runs that can be asked about their states, as often as needed: one's own, another program's, a stored one.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "scenario/scenario.h"
#include "simulation/hash.h"
#include "simulation/world.h"

namespace morula {

/// The hashes of a run's states at regular steps.
struct HashTrace {
  std::vector<ChainLink> links;  // their chain begins with the first of them
  std::uint64_t lastStep = 0;    // where the run ended, or where asking stopped
  std::string failure;           // why it could not go on there; "" if it could
};

class RunSource {
 public:
  explicit RunSource(std::string called) : name(std::move(called)) {}
  virtual ~RunSource() = default;
  /// The states at steps from, from + every, … not after `to`, as far as the run goes.
  virtual HashTrace hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) = 0;
  /// The state after this step; where the run fails there, the failed state. Null if it cannot be had, and
  /// then `noState` says why.
  virtual std::unique_ptr<World> stateAt(std::uint64_t step) = 0;
  std::string name;  // "this program, avx2, 1 thread"
  std::string noState;
};

/// A run in this process. `make` gives its world at step 0, `advance` goes on by one step; both must do the
/// same each time. `watch` is called before every step and may throw to end the asking. It goes on from where
/// it stands if it can, and starts anew if it is asked about the past.
class OwnRun : public RunSource {
 public:
  OwnRun(std::string name, std::function<World()> make, std::function<void(World&)> advance,
         std::function<void(const World&)> watch = {});
  ~OwnRun() override;
  HashTrace hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) override;
  std::unique_ptr<World> stateAt(std::uint64_t step) override;

 private:
  /// Goes to the step or to the end of the run. False where the run ends before.
  bool goTo(std::uint64_t step);
  /// False where the state is none.
  bool addLink(HashTrace& trace);

  std::function<World()> make_;
  std::function<void(World&)> advance_;
  std::function<void(const World&)> watch_;
  std::unique_ptr<World> world_;  // where the run stands; null: not begun
  std::string failure_;           // why it stands there for good
};

/// The scenario, which must outlive it, computed so; stops at signals.
OwnRun scenarioRun(const Scenario& scenario, const Execution& how, const std::string& called = "this program");

/// A run of another Morula, perhaps an older build, which is asked for its hashes and states.
class ProgramRun : public RunSource {
 public:
  /// `program` is started as `PROGRAM trail SCENARIO …`; `make` gives the scenario's world here, into which
  /// its states are restored. Both must know the same scenario file.
  ProgramRun(std::string program, std::string scenario, std::function<World()> make,
             std::vector<std::string> more = {});
  /// Throws InputError if the program cannot be started or does not answer.
  HashTrace hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) override;
  /// Null if its states are of a form that is not known here.
  std::unique_ptr<World> stateAt(std::uint64_t step) override;

 private:
  std::string answer(const std::vector<std::string>& arguments) const;

  std::string scenario_;
  std::function<World()> make_;
  std::vector<std::string> more_;  // further options of `trail`
};

/// A run in a database: the hashes of its states, without the states themselves.
class StoredRunSource : public RunSource {
 public:
  /// `chain` as the database has it, `steps` and `failure` as the run ended.
  StoredRunSource(std::string name, std::vector<ChainLink> chain, std::uint64_t steps, std::string failure);
  /// Returns the hashes of those steps that are stored.
  HashTrace hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) override;
  std::unique_ptr<World> stateAt(std::uint64_t) override;

 private:
  std::vector<ChainLink> chain_;
  std::uint64_t steps_;
  std::string failure_;
};

/// Returns the mistake in a stored chain itself: a row lost, put in or edited. Each link's hash must follow from its
/// state and the link before, each state's from its parts. "" if all holds. `step`: of the first bad link.
std::string findBrokenLink(const std::vector<ChainLink>& chain, std::uint64_t& step);

std::string writeHashTrace(const HashTrace& trace);
/// Throws InputError for anything else.
HashTrace readHashTrace(const std::string& text);

}  // namespace morula
