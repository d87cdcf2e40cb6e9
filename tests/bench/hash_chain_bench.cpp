// Measures the cost of the chain of hashes: a scenario runs twice side by side, with and without, in turns of 64 steps.
//
//   hash_chain_bench [SCENARIO]     default: scenarios/thesis/elegans-128.yaml
#include <fmt/format.h>

#include <filesystem>

#include "scenario/scenario.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"
#include "store/recorder.h"
#include "store/store.h"
#include "system/clock.h"

using namespace morula;

namespace {

constexpr std::uint64_t turn = 64;  // steps between two links

struct Contestant {
  World world;
  Recorder recorder;
  double seconds = 0;

  void go() {
    seconds += timeOf(ClockKind::process, [&] {
      for (std::uint64_t i = 0; i < turn && !finished(world); ++i) {
        step(world);
        recorder.observe(world);
      }
    });
  }
};

/// Returns the seconds that it takes to store the recorded rows.
double secondsToStore(Contestant& c, const std::filesystem::path& file) {
  return timeOf(ClockKind::process, [&] {
    RunRecord record;
    record.scenario = "hash-chain";
    record.scenarioHash = std::string(32, '0');
    auto store = Store::openForWriting(file);
    const auto id = store.begin(record);
    store.finish(id, endOf(c.world, RunStatus::done), c.recorder.take(c.world));
  });
}

}  // namespace

int main(int argc, char** argv) {
  const std::string file = argc > 1 ? argv[1] : "scenarios/thesis/elegans-128.yaml";
  const Scenario scenario = loadScenario(file);
  Contestant without{makeWorld(scenario.scene), Recorder{}}, with{makeWorld(scenario.scene), Recorder({{}, turn})};
  with.recorder.observe(with.world);
  for (bool first = true; !finished(without.world) || !finished(with.world); first = !first) {
    (first ? without : with).go();
    (first ? with : without).go();
  }
  const auto folder = std::filesystem::temp_directory_path() / "morula-hash-chain";
  std::filesystem::create_directories(folder);
  const std::size_t links = with.recorder.chain().size();
  const double stored = secondsToStore(with, folder / "with.db") - secondsToStore(without, folder / "without.db");
  std::filesystem::remove_all(folder);
  fmt::print(
      "{}: {} steps, {} links\n  without {:.3f} s, with {:.3f} s: {:.2f} %; storing it {:.3f} s: {:.2f} % in all\n",
      file, without.world.clock.step, links, without.seconds, with.seconds, 100 * (with.seconds / without.seconds - 1),
      stored, 100 * ((with.seconds + stored) / without.seconds - 1));
}
