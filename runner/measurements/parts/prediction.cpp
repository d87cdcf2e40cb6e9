#include "parts/prediction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/maths.h"
#include "base/number_text.h"
#include "loop/simulate.h"
#include "observation/measures.h"
#include "parts/rates.h"
#include "physics/integrator.h"
#include "store/recorder.h"

namespace morula {
namespace {

struct Cost {
  std::optional<double> seconds, bytes;
};
using Costs = std::map<std::string, Cost>;

/// Sums over the whole run.
struct Sums {
  double cellSteps = 0, laneSteps = 0;  // laneSteps: with unused lanes
  double cellSearches = 0;
  double changes = 0;  // living cells, summed over all moments with births or deaths
  double samples = 0, sampledCells = 0;
  double surfaces = 0;  // surfaces in samples
};

double samplesIn(const Era& era, bool last, double every) {
  return std::ceil(era.to / every - 1e-9) - std::ceil(era.from / every - 1e-9) + last;
}

Sums addUp(const Life& life, const std::vector<EraCounts>& eras, const Scenario& scenario, Isa isa) {
  Sums s;
  const Precision precision =
      scenario.scene.mechanics ? scenario.scene.mechanics->physics.precision : Precision::binary64;
  for (std::size_t i = 0; i < life.eras.size(); ++i) {
    const double cells = double(life.eras[i].cells);
    if (!eras.empty()) {
      s.cellSteps += eras[i].steps * cells;
      s.laneSteps += eras[i].steps * cells * laneShare(isa, life.eras[i].cells, precision);
      s.cellSearches += eras[i].searches * cells;
    }
    if (i > 0) s.changes += cells;
    const bool last = i + 1 == life.eras.size();
    const auto& every = scenario.record.every;
    const auto& meshes = scenario.record.meshes;
    const double kept = meshes ? samplesIn(life.eras[i], last, *meshes) : 0;
    const double asked = every ? samplesIn(life.eras[i], last, *every) : (i == 0) + last;  // samples at start and end
    const double n = std::max(asked, kept);
    s.surfaces += kept * cells;
    s.samples += n;
    s.sampledCells += n * cells;
  }
  return s;
}

double recordBytes(const Sums& sums, const World& world) {
  double perCell = double(sizeof(CellMeasures) + CellMeasures::bytes());
  if (world.contacts)
    perCell += 6 * double(sizeof(ContactMeasures) + ContactMeasures::bytes());  // a dozen neighbours, shared by two
  if (!world.bodies) return sums.samples * sizeof(Sample);
  const Bodies& b = *world.bodies;
  const double vertices = double(b.areSpheres() ? b.surface.vertices.size() : b.mesh.mesh.vertices.size());
  return sums.samples * sizeof(Sample) + sums.sampledCells * perCell +
         sums.surfaces * (sizeof(CellSurface) + 6 * vertices);
}

/// Predicts the costs of a scene without bodies: genes and records.
void predictLineage(Costs& costs, Prediction& f, const Scenario& scenario, const PredictionOptions& options) {
  const World world = makeWorld(scenario.scene, options.execution);
  const Sums sums = addUp(f.life, {}, scenario, options.execution.isa);
  f.steps = double(f.life.moments);
  costs["biology"].bytes = double(sizeof(LineageEntry)) * double(2 * f.life.divisions + 1) + 36.0 * double(f.cells);
  costs["samples"].bytes = recordBytes(sums, world);
  // A hash is taken at every moment, over living cells and as many mothers.
  costs["hashes"].seconds = measureObservation(world).hash * 2 * double(f.life.cellsAsked);
  f.triedWhole = f.life.whole;
  f.triedTime = f.life.eras.back().to;
}

/// Adds a remark if the time step may change. An automatic step is a power of two: if its limit is just above one, a
/// small change halves it.
void warnOfTimeSteps(Prediction& f, const TrialRun& trial) {
  constexpr double near = 1.1;  // limits are predicted to within 10 %
  const auto& fixed = trial.world.bodies->parameters.timeStep;
  for (std::size_t i = trial.eras.size(); i < f.life.eras.size(); ++i) {
    const Era& era = f.life.eras[i];
    const double limit = predictTimeStepLimit(trial, era.generation);
    if (fixed && *fixed > limit)
      f.remarks.push_back(fmt::format(
          "physics.time_step will be too long from {} cells on, because cells get lighter with each division",
          era.cells));
    else if (!fixed && limit < near * powerOfTwoBelow(limit))
      f.remarks.push_back(
          fmt::format("from {} cells on the time step may be half as long, and steps twice as many", era.cells));
    else continue;
    return;
  }
}

/// Returns what binds the time step of the world as it is; absent without an automatic one.
std::optional<BindingLimit> bindingLimit(World& world) {
  const PhysicsParameters& p = world.bodies->parameters;
  const IntegratorKind& kind = kindOf(p.integrator);
  if (world.bodies->count == 0 || p.timeStep || kind.settles || kind.solvesForces) return {};
  const BindingLimit binding = findBindingLimit(world);
  return binding.factor < INFINITY ? std::optional(binding) : std::nullopt;
}

/// Returns the costs of the steps themselves.
Costs costsOfSteps(const StepRates& rates, const Sums& sums, double pairs, double vertices) {
  const double lanes = sums.laneSteps * vertices;
  Costs costs;
  costs["springs"].seconds = rates.springs * lanes;
  costs["damping"].seconds = rates.damping * lanes;
  costs["bending"].seconds = rates.bending * lanes;
  costs["pressure"].seconds = rates.pressure * lanes;
  costs["shape-matching"].seconds = rates.shapeMatching * lanes;
  costs["drag"].seconds = rates.drag * lanes;
  costs["integration"].seconds = rates.integration * lanes;
  costs["shell"].seconds = rates.shell * lanes;
  costs["contact"].seconds = rates.snapshots * lanes + rates.pair * pairs;
  costs["viscosity"].seconds = rates.viscosityOfPair * pairs;
  costs["search"].seconds = rates.search * sums.cellSearches * vertices;
  costs["connections"].seconds = rates.connections * sums.cellSteps * vertices;
  return costs;
}

/// Returns the trial run's time over that explained by its rates. Calls and checks take further time, and separately
/// measured rates find less of the world in the cache.
double slowness(const Prediction& f, const TrialRun& trial, const StepRates& rates, const Scenario& scenario, Isa isa) {
  const Life past{{f.life.eras.begin(), f.life.eras.begin() + std::ptrdiff_t(trial.eras.size())}};
  double pairs = 0, explained = 0;
  for (const EraCounts& era : trial.eras) pairs += era.pairs;
  for (const auto& [name, cost] :
       costsOfSteps(rates, addUp(past, trial.eras, scenario, isa), pairs, verticesPerCell(*trial.world.bodies)))
    explained += *cost.seconds;
  return explained > 0 ? std::clamp((trial.seconds - trial.changeSeconds) / explained, 0.2, 3.0) : 1;
}

void addMemory(Costs& costs, const MemoryUse& m) {
  costs["biology"].bytes = double(m.cells);
  costs["bodies"].bytes = double(m.mesh + m.bodies + m.scratch);
  costs["contact"].bytes = double(m.snapshots + m.listRows + m.listPairs);
  costs["search"].bytes = double(m.search);
  costs["connections"].bytes = double(m.connections);
}

void predictBodies(Costs& costs, Prediction& f, const Scenario& scenario, const PredictionOptions& options) {
  TrialRun trial = tryBeginning(makeWorld(scenario.scene, options.execution), f.life, options.trial);
  World& world = trial.world;
  const Isa isa = options.execution.isa;
  f.vertices = world.bodies->mesh.vertexCount();
  const double vertices = verticesPerCell(*world.bodies);
  f.triedWhole = trial.whole;
  f.triedTime = world.clock.time;
  const auto eras = extrapolate(f.life, trial);
  const Sums sums = addUp(f.life, eras, scenario, isa);
  for (const EraCounts& o : eras) f.steps += o.steps, f.searches += o.searches, f.pairs += o.pairs;
  f.vertexSteps = sums.cellSteps * vertices;

  const MemoryUse memory = extrapolateMemory(f.life, trial);
  // If all cells have died an egg is measured instead.
  World egg = makeWorld(scenario.scene, options.execution);
  const StepRates rates = measureRates(world.bodies->count > 0 ? world : egg);
  const double factor = slowness(f, trial, rates, scenario, isa);
  for (const auto& [name, cost] : costsOfSteps(rates, sums, f.pairs, vertices))
    costs[name].seconds = factor * *cost.seconds;
  const double perChange = trial.changeCells ? trial.changeSeconds / double(trial.changeCells) : 0;
  costs["division"].seconds = perChange * sums.changes;
  const ObservationRates watching = measureObservation(world);
  costs["hashes"].seconds = watching.hash * vertices * sums.cellSteps / double(stepsPerHash);
  costs["samples"].seconds = watching.sample * vertices * sums.sampledCells;

  addMemory(costs, memory);
  costs["samples"].bytes = recordBytes(sums, world);
  costs["hashes"].bytes = f.steps / double(stepsPerHash) * sizeof(ChainLink);
  warnOfTimeSteps(f, trial);
  f.binding = bindingLimit(world);
  if (!scenario.scene.senses.empty() || scenario.scene.cycle.divisionSize)
    f.remarks.push_back("senses and sizes for division are not predicted; divisions are those of the genes alone");
  if (scenario.scene.mechanics->physics.growth)
    f.remarks.push_back("the effect of growth on the time step is not predicted beyond the rehearsal");
}

void addPictures(Costs& costs, const Prediction& f, const Scenario& scenario, const PredictionOptions& options) {
  if (!options.secondsPerPicture || !f.vertices) return;
  double pictures = 2;
  if (scenario.record.pictures) pictures += std::floor(f.life.eras.back().to / *scenario.record.pictures + 1e-9) + 1;
  costs["pictures"].seconds = pictures * *options.secondsPerPicture;
}

void addShares(Prediction& f) {
  const double whole = f.seconds(), vertices = double(f.vertices) * double(f.cells);
  for (PartCost& c : f.costs) {
    const bool inSteps = c.seconds && !c.afterwards;
    if (inSteps && whole > 0) c.share = *c.seconds / whole;
    if (inSteps && f.vertexSteps > 0) c.nsPerVertexStep = 1e9 * *c.seconds / f.vertexSteps;
    if (c.bytes && vertices > 0) c.bytesPerVertex = *c.bytes / vertices;
  }
}

}  // namespace

std::optional<Scenario> settledInstead(const Scenario& scenario) {
  const auto& mechanics = scenario.scene.mechanics;
  if (!mechanics || kindOf(mechanics->physics.integrator).settles) return std::nullopt;
  return readScenario(scenario.resolved, scenario.file, "",
                      {parseOverride("physics.integrator=quasi-static"), parseOverride("physics.time_step=null")},
                      scenario.files);
}

double Prediction::seconds() const {
  double sum = 0;
  for (const PartCost& c : costs) sum += c.afterwards ? 0 : c.seconds.value_or(0);
  return sum;
}

double Prediction::bytes() const {
  double sum = 0;
  for (const PartCost& c : costs) sum += c.bytes.value_or(0);
  return sum;
}

Prediction predictCost(const Scenario& scenario, const PredictionOptions& options) {
  Prediction f;
  f.life = predictLife(scenario.scene);
  f.cells = f.life.maxCells();
  if (!f.life.whole)
    f.remarks.push_back("the run has too many cells to predict; these are the costs of its beginning only");
  Costs costs;
  costs["biology"].seconds = f.life.seconds;
  if (scenario.scene.mechanics) predictBodies(costs, f, scenario, options);
  else predictLineage(costs, f, scenario, options);
  addPictures(costs, f, scenario, options);
  for (Part& part : partsOf(scenario, options.ask)) {
    if (!part.engaged) {
      f.absent.push_back(std::move(part));
      continue;
    }
    const Cost cost = costs[part.name];
    const bool afterwards = part.name == "pictures" || part.name == "golden";
    f.costs.push_back(
        {.part = std::move(part), .seconds = cost.seconds, .bytes = cost.bytes, .afterwards = afterwards});
  }
  addShares(f);
  return f;
}

}  // namespace morula
