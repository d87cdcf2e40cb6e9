// A scene that goes on for any time, in one piece and in pieces. It has 64 cells that grow, stick, and connect for a
// while; in every cycle half of them divide and half die.
//
//   soak STEPS PIECES
//
// Checks: the hash at the end of each piece, in a new world that goes on from a checkpoint; the growth of memory after
// a tenth of the steps; and energy. In intervals without events the lost energy must be that of drag, damping and
// viscosity, and the total must not creep up.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "connections/connections.h"
#include "observation/energy.h"
#include "scenario/scenario.h"
#include "simulation/restore.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"

using namespace morula;

namespace {

// Six rounds make 64 cells. From then on a daughter A divides at her cycle and a daughter B dies at hers. p and q have
// different cycle lengths, so that one has events while the other rests.
const char* const scene = R"(morula: 1
name: soak
seed: 1
dna: |
  START: a
  g1(b|a)
  g2(divide|a)
  g3(c|b)
  g4(divide|b)
  g5(d|c)
  g6(divide|c)
  g7(e|d)
  g8(divide|d)
  g9(f|e)
  g10(divide|e)
  g11(p|f, A)
  g12(q|f, B)
  g13(divide|f)
  g14(p|p, A)
  g15(divide|p, A)
  g16(grow|p, A)
  g17(die|p, B)
  g18(q|q, A)
  g19(divide|q, A)
  g20(grow|q, A)
  g21(die|q, B)
cycle: {length: 0.25, per-substance: {p: 2.18, q: 2.81}}
stop: {time: 1e6}
physics:
  time_step: 0.000244140625
  drag: 1
  mesh: {icosphere: 1}
  growth: {rate: 1.2, until: 0.03125}
  contact: {adhesion: 0.3, viscosity: 0.1}
connections: {release-age: 1.2}
)";

constexpr double maxMissing = 1e-3;  // [1] of the energy, in an interval without events
constexpr double maxCreep = 1.25;    // [1] mean energy of any tenth over that of the first tenth with all cells
constexpr double maxMemory = 16e6;   // [byte] growth after the first tenth: records of 8000 divisions, and more
constexpr int watched = 128;         // [steps] length of an interval

double memoryTaken() {
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// The numbers that change with every event; equal objects have no event between them.
struct Quiet {
  std::size_t lives = 0, ties = 0;
  double sizes = 0, released = 0;
  explicit Quiet(const World& world) : lives(world.lineage.entries.size()), ties(world.connections->history.size()) {
    for (const int slot : world.bodies->slots) sizes += world.bodies->restScale[slot];
    for (const ConnectionRecord& tie : world.connections->history) released += tie.released;
  }
  bool operator==(const Quiet&) const = default;
};

struct Balance {
  double worst = 0;  // [1] largest error of the balance
  int whiles = 0;

  /// Makes `watched` steps and checks their energy balance if there was no event.
  void watch(World& world) {
    const Quiet before(world);
    const double begin = measureEnergy(world).total();
    double taken = 0, power = measureDissipation(world);
    for (int i = 0; i < watched; ++i) {
      step(world);
      const double now = measureDissipation(world);
      taken += 0.5 * (power + now) * world.clock.timeStep;
      power = now;
    }
    if (!(Quiet(world) == before)) return;
    const Energy end = measureEnergy(world);
    worst = std::max(worst, std::abs(end.total() + taken - begin) / (begin - 2 * end.adhesion));
    ++whiles;
  }
};

void goOn(World& world, std::uint64_t to) {
  while (world.clock.step < to) takeSteps(world, std::min<std::uint64_t>(64, to - world.clock.step));
}

bool holds(bool condition, const std::string& what) {
  std::printf("%s%s\n", condition ? "" : "FAILED: ", what.c_str());
  return condition;
}

int soak(std::uint64_t steps, std::uint64_t pieces) {
  const Scenario scenario = readScenario(scene, "soak.yaml", "");
  const Execution execution{.isa = bestIsa(), .threads = 1};
  World world = makeWorld(scenario.scene, execution);
  const std::uint64_t tenth = steps / 10, all = 7000;  // steps after which there are 64 cells
  Balance balance;
  double memory = 0;
  std::vector<std::pair<double, int>> energies(11);  // [tenth] sums and their numbers of terms
  int least = 1000, most = 0;
  std::vector<Hash> hashes;
  for (std::uint64_t piece = 1; piece <= pieces; ++piece) {
    const std::uint64_t to = steps * piece / pieces;
    while (world.clock.step < to) {
      goOn(world, std::min(to, world.clock.step + 872));
      if (world.clock.step + watched <= to) balance.watch(world);
      if (world.clock.step < all) continue;
      const int count = world.bodies->count;
      least = std::min(least, count), most = std::max(most, count);
      auto& [sum, times] = energies[(world.clock.step - all) / tenth];
      sum += measureEnergy(world).total(), ++times;
    }
    hashes.push_back(stateHash(world));
    if (memory == 0 && world.clock.step >= tenth) memory = memoryTaken();
  }
  const double grown = memoryTaken() - memory;
  std::size_t died = 0;
  for (const LineageEntry& cell : world.lineage.entries) died += cell.fate == Fate::died;
  bool fine =
      holds(world.clock.step == steps && died > 0 && world.connections->history.size() > 64,
            fmt::format("{} steps, {} divisions, {} deaths, {} connections made; {} to {} cells", world.clock.step,
                        world.divisions.size(), died, world.connections->history.size(), least, most));
  fine &= holds(least >= 32 && most <= 128, "cells: as many as were meant");
  fine &= holds(grown <= maxMemory, fmt::format("memory: {:.1f} MB more than {:.1f} MB", grown / 1e6, memory / 1e6));
  fine &= holds(balance.whiles > 0 && balance.worst <= maxMissing,
                fmt::format("energy: {:.2g} of it missing at most, in {} whiles of {} steps without events",
                            balance.worst, balance.whiles, watched));
  double early = 0, late = 0;
  for (const auto& [sum, times] : energies)
    if (times > 0) (early == 0 ? early : late) = std::max(late, sum / times);
  fine &= holds(late <= maxCreep * early,
                fmt::format("energy: {:.4g} in the mean of a tenth, at most {:.4g} later", early, late));

  std::string state = saveState(makeWorld(scenario.scene, execution));
  for (std::uint64_t piece = 1; piece <= pieces; ++piece) {
    World other = makeWorld(scenario.scene, execution);
    restoreState(other, state);
    goOn(other, steps * piece / pieces);
    if (stateHash(other) != hashes[piece - 1])
      return holds(false, fmt::format("piece {} ends with another hash", piece)), 1;
    state = saveState(other);
  }
  holds(true, fmt::format("{} pieces: the same hash at the end of each, {}", pieces, hashes.back().text()));
  return fine ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("usage: soak STEPS PIECES\n", stderr), 2;
  try {
    return soak(std::strtoull(argv[1], nullptr, 10), std::strtoull(argv[2], nullptr, 10));
  } catch (const std::exception& e) { return std::printf("FAILED: %s\n", e.what()), 1; }
}
