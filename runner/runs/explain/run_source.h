#pragma once
// Runs that can be asked about their states as often as needed: of this program, of another program, or stored.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "scenario/scenario.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"

namespace morula {

/// The hashes of a run's states at regular steps.
struct HashTrace {
  std::vector<ChainLink> links;  // a chain that begins with its first link
  std::uint64_t lastStep = 0;    // last step of the run, or of the question
  std::string failure;           // why the run failed there; "" if it did not
};

class RunSource {
 public:
  explicit RunSource(std::string called) : name(std::move(called)) {}
  virtual ~RunSource() = default;
  /// Returns hashes of the states at steps from, from + every, … up to `to`, as far as the run goes.
  virtual HashTrace hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) = 0;
  /// Returns the state after this step; if the run fails there, the failed state. Returns null if the state is not
  /// available; `noState` then says why.
  virtual std::unique_ptr<World> stateAt(std::uint64_t step) = 0;
  std::string name;  // "this program, avx2, 1 thread"
  std::string noState;
};

/// A run in this process. `make` returns its world at step 0, `advance` makes one step; both must be deterministic.
/// `watch` is called before every step, and may throw to end the question. The run continues from its present step if
/// it can, and starts anew for an earlier one.
class OwnRun : public RunSource {
 public:
  OwnRun(std::string name, std::function<World()> make, std::function<void(World&)> advance,
         std::function<void(const World&)> watch = {});
  ~OwnRun() override;
  HashTrace hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) override;
  std::unique_ptr<World> stateAt(std::uint64_t step) override;

 private:
  /// Advances to the step. Returns false if the run ends before.
  bool goTo(std::uint64_t step);
  /// Adds the hashes of the present state. Returns false if the state holds numbers that are not finite.
  bool addLink(HashTrace& trace);

  std::function<World()> make_;
  std::function<void(World&)> advance_;
  std::function<void(const World&)> watch_;
  std::unique_ptr<World> world_;  // the present state; null: not begun
  std::string failure_;           // why the run cannot go on; "" if it can
};

/// Returns a run of the scenario, which must outlive it, with `how`; signals stop the run.
OwnRun scenarioRun(const Scenario& scenario, const Execution& how, const std::string& called = "this program");

/// A run of another Morula program, perhaps an older build, which is asked for hashes and states.
class ProgramRun : public RunSource {
 public:
  /// `program` is started as `PROGRAM internal trail SCENARIO …`. `make` returns the scenario's world here, into which
  /// states are restored. Both must use one scenario file.
  ProgramRun(std::string program, std::string scenario, std::function<World()> make,
             std::vector<std::string> more = {});
  /// Throws InputError if the program cannot be started or does not answer.
  HashTrace hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) override;
  /// Returns null if the program's states have a form that is unknown here.
  std::unique_ptr<World> stateAt(std::uint64_t step) override;

 private:
  std::string answer(const std::vector<std::string>& arguments) const;

  std::string scenario_;
  std::function<World()> make_;
  std::vector<std::string> more_;  // further options of `internal trail`
};

/// A run in a database: the hashes of its states, without the states themselves.
class StoredRunSource : public RunSource {
 public:
  /// `chain` as in the database; `steps` and `failure` as the run ended.
  StoredRunSource(std::string name, std::vector<ChainLink> chain, std::uint64_t steps, std::string failure);
  /// Returns the hashes of those steps that are stored.
  HashTrace hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) override;
  std::unique_ptr<World> stateAt(std::uint64_t) override;

 private:
  std::vector<ChainLink> chain_;
  std::uint64_t steps_;
  std::string failure_;
};

/// Returns the mistake in a stored chain: a row lost, inserted or edited; "" if there is none. A link's hash must
/// follow from its state and the previous link, a state's hash from its parts. `step`: step of the first bad link.
std::string findBrokenLink(const std::vector<ChainLink>& chain, std::uint64_t& step);

std::string writeHashTrace(const HashTrace& trace);
/// Reads what writeHashTrace wrote. Throws InputError for any other text.
HashTrace readHashTrace(const std::string& text);

}  // namespace morula
