#include "parts/forecast.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/maths.h"
#include "parts/outlook.h"
#include "parts/rates.h"
#include "simulation/measures.h"
#include "store/recorder.h"

namespace morula {

namespace {

struct Cost {
  std::optional<double> seconds, bytes;
};
using Costs = std::map<std::string, Cost>;

/// Sums over the whole run.
struct Sums {
  double cellSteps = 0, laneSteps = 0;  // laneSteps: with the lanes that nobody uses
  double cellSearches = 0;
  double upheavals = 0;  // cells that are there when others are born or die, over all such moments
  double samples = 0, sampledCells = 0;
};

double samplesIn(const Era& era, bool last, double every) {
  return std::ceil(era.to / every - 1e-9) - std::ceil(era.from / every - 1e-9) + last;
}

Sums addUp(const Life& life, const std::vector<Outlook>& eras, const Scenario& scenario, Isa isa) {
  Sums s;
  for (std::size_t i = 0; i < life.eras.size(); ++i) {
    const double cells = double(life.eras[i].cells);
    if (!eras.empty()) {
      s.cellSteps += eras[i].steps * cells;
      s.laneSteps += eras[i].steps * cells * laneShare(isa, life.eras[i].cells);
      s.cellSearches += eras[i].searches * cells;
    }
    if (i > 0) s.upheavals += cells;
    if (scenario.record.every) {
      const double n = samplesIn(life.eras[i], i + 1 == life.eras.size(), *scenario.record.every);
      s.samples += n;
      s.sampledCells += n * cells;
    }
  }
  return s;
}

double recordBytes(const Sums& sums, const World& world) {
  double perCell = sizeof(CellMeasures);
  if (world.contacts) perCell += 6 * sizeof(ContactMeasures);  // a dozen neighbours, shared by two
  return sums.samples * sizeof(Sample) + (world.bodies ? sums.sampledCells * perCell : 0);
}

/// Without bodies: the genes, and what is written down.
void foretellLineage(Costs& costs, Forecast& f, const Scenario& scenario, const ForecastOptions& options,
                     const Sums& sums) {
  World world = makeWorld(scenario.scene, options.execution);
  costs["biology"].bytes =
      double(sizeof(LineageEntry)) * double(2 * f.life.divisions + 1) + 36.0 * double(f.cells);
  costs["samples"].bytes = recordBytes(sums, world);
  // A hash at every step, over all cells there ever were.
  Scene genes = scenario.scene;
  double ever = 0;
  for (const Era& era : f.life.eras) ever += 2.0 * double(era.cells);
  costs["hashes"].seconds = measureObservation(world).hash * ever;
  costs["samples"].seconds = 0;
  f.rehearsed = f.life.whole;
  f.rehearsedTime = f.life.eras.back().to;
}

/// An automatic step is a power of two. Where its limit lies just above one, little makes it half as long.
void warnOfTimeSteps(Forecast& f, const Rehearsal& rehearsal) {
  constexpr double near = 1.1;  // limits are foretold to within 10 %
  const auto& fixed = rehearsal.world.bodies->parameters.timeStep;
  for (std::size_t i = rehearsal.stretches.size(); i < f.life.eras.size(); ++i) {
    const Era& era = f.life.eras[i];
    const double limit = foretellTimeStepLimit(rehearsal, era.generation);
    if (fixed && *fixed > limit)
      f.remarks.push_back(fmt::format(
          "physics.time_step will be too long from {} cells on: cells get lighter with each division",
          era.cells));
    else if (!fixed && limit < near * powerOfTwoBelow(limit))
      f.remarks.push_back(fmt::format(
          "from {} cells on the time step may be half as long, and steps twice as many", era.cells));
    else continue;
    return;
  }
}

void foretellBodies(Costs& costs, Forecast& f, const Scenario& scenario, const ForecastOptions& options) {
  Rehearsal rehearsal = rehearse(makeWorld(scenario.scene, options.execution), f.life, options.rehearsal);
  World& world = rehearsal.world;
  f.vertices = world.bodies->vertexCount();
  f.rehearsed = rehearsal.whole;
  f.rehearsedTime = world.clock.time;
  const auto eras = lookAhead(f.life, rehearsal);
  const Isa isa = options.execution.isa;
  const Sums sums = addUp(f.life, eras, scenario, isa);
  for (const Outlook& o : eras) f.steps += o.steps, f.searches += o.searches, f.pairs += o.pairs;
  f.vertexSteps = sums.cellSteps * f.vertices;

  const MemoryUse memory = foretellMemory(f.life, rehearsal);
  const StepRates rates = measureRates(world, double(memory.bodies + memory.contact()));
  const ObservationRates watching = measureObservation(world);
  const auto total = [&](const Sums& s, double pairs) {
    const double lanes = s.laneSteps * f.vertices, all = s.cellSteps * f.vertices;
    costs["springs"].seconds = rates.springs * lanes;
    costs["damping"].seconds = rates.damping * lanes;
    costs["pressure"].seconds = rates.pressure * lanes;
    costs["drag"].seconds = rates.drag * lanes;
    costs["integration"].seconds = rates.integration * lanes;
    costs["shell"].seconds = rates.shell * lanes;
    costs["contact"].seconds = rates.snapshots * lanes + rates.pair * pairs;
    costs["friction"].seconds = rates.frictionOfPair * pairs;
    costs["search"].seconds = rates.search * s.cellSearches * f.vertices;
    costs["connections"].seconds = rates.connections * all;
    double sum = 0;
    for (const auto& [name, cost] : costs) sum += name == "biology" ? 0 : cost.seconds.value_or(0);
    return sum;
  };
  // What the rehearsal took beyond its rates, for calls and checks, is each part's in proportion.
  const Life past{{f.life.eras.begin(), f.life.eras.begin() + std::ptrdiff_t(rehearsal.stretches.size())}};
  std::vector<Outlook> counted;
  double pastPairs = 0;
  for (const Stretch& s : rehearsal.stretches) {
    counted.push_back({double(s.steps), double(s.rebuilds), double(s.pairs)});
    pastPairs += double(s.pairs);
  }
  const Sums pastSums = addUp(past, counted, scenario, isa);
  const double explained = total(pastSums, pastPairs);
  const double unrest = rehearsal.upheavalSeconds;
  const double factor = explained > 0 ? std::clamp((rehearsal.seconds - unrest) / explained, 1.0, 3.0) : 1;
  total(sums, f.pairs);
  for (auto& [name, cost] : costs)
    if (name != "biology" && cost.seconds) *cost.seconds *= factor;
  const double perUpheaval = rehearsal.upheavalCells ? unrest / double(rehearsal.upheavalCells) : 0;
  costs["division"].seconds = perUpheaval * sums.upheavals;
  costs["hashes"].seconds = watching.hash * f.vertices * sums.cellSteps / double(stepsPerHash);
  costs["samples"].seconds = watching.sample * f.vertices * sums.sampledCells;

  costs["biology"].bytes = double(memory.cells);
  costs["bodies"].bytes = double(memory.mesh + memory.bodies + memory.scratch);
  costs["contact"].bytes = double(memory.snapshots + memory.listRows + memory.listPairs);
  costs["search"].bytes = double(memory.search);
  costs["connections"].bytes = double(memory.connections);
  costs["samples"].bytes = recordBytes(sums, world);
  costs["hashes"].bytes = f.steps / double(stepsPerHash) * sizeof(StepHash);
  warnOfTimeSteps(f, rehearsal);
  if (scenario.scene.mechanics->physics.growth)
    f.remarks.push_back("what growth does to the time step is not foreseen beyond the rehearsal");
}

void addPictures(Costs& costs, const Forecast& f, const Scenario& scenario, const ForecastOptions& options) {
  if (!options.secondsPerPicture || !f.vertices) return;
  double pictures = 2;
  if (scenario.record.pictures)
    pictures += std::floor(f.life.eras.back().to / *scenario.record.pictures + 1e-9) + 1;
  costs["pictures"].seconds = pictures * *options.secondsPerPicture;
}

}  // namespace

double Forecast::seconds() const {
  double sum = 0;
  for (const PartCost& c : costs) sum += c.afterwards ? 0 : c.seconds.value_or(0);
  return sum;
}

double Forecast::bytes() const {
  double sum = 0;
  for (const PartCost& c : costs) sum += c.bytes.value_or(0);
  return sum;
}

Forecast foretell(const Scenario& scenario, const ForecastOptions& options) {
  Forecast f;
  f.life = foretellLife(scenario.scene);
  f.cells = f.life.mostCells();
  if (!f.life.whole)
    f.remarks.push_back("there are more cells than were followed: this is the beginning of the run only");
  Costs costs;
  costs["biology"].seconds = f.life.seconds;
  if (scenario.scene.mechanics) foretellBodies(costs, f, scenario, options);
  else foretellLineage(costs, f, scenario, options, addUp(f.life, {}, scenario, options.execution.isa));
  addPictures(costs, f, scenario, options);
  for (Part& part : partsOf(scenario, options.ask)) {
    if (!part.engaged) {
      f.absent.push_back(std::move(part));
      continue;
    }
    const Cost cost = costs[part.name];
    const bool afterwards = part.name == "pictures" || part.name == "golden";
    f.costs.push_back({std::move(part), cost.seconds, cost.bytes, afterwards});
  }
  return f;
}

}  // namespace morula
