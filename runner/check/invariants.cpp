#include "check/invariants.h"

#include <algorithm>
#include <cmath>

#include "files/text.h"
#include "mesh/measures.h"
#include "simulation/measures.h"
#include "yaml/numbers.h"

namespace morula {

namespace {

/// Of the scene's meshes at rest, before their cells' rest scales.
std::vector<double> restVolumes(const Bodies& b) {
  std::vector<double> volumes;
  for (std::size_t i = 0; i <= b.coarser.size(); ++i) {
    const Mesh& mesh = b.meshAt(static_cast<int>(i)).mesh;
    const double r = b.parameters.cell.radius;
    volumes.push_back(b.areSpheres() ? 12.566370614359172 / 3 * (r * r * r)
                                     : measureVolume(mesh.vertices, mesh.faces));
  }
  return volumes;
}

/// Every edge once: in one of its two faces it runs upwards.
double membraneEnergy(const Bodies& b, int slot) {
  const Mesh& rest = b.meshOf(slot).mesh;
  double sum = 0;
  for (const Face& face : rest.faces)
    for (int k = 0; k < 3; ++k) {
      const int i = face[k], j = face[(k + 1) % 3];
      if (i > j) continue;
      const double length = norm(b.vertex(slot, i) - b.vertex(slot, j));
      const double off = length - b.restScale[slot] * norm(rest.vertices[i] - rest.vertices[j]);
      sum += off * off;
    }
  return 0.5 * b.parameters.membrane.stiffness * sum;
}

double contentsEnergy(const Bodies& b, int slot) {
  const double k = b.pressureConstant[slot], outside = b.parameters.pressure.outside;
  if (k == 0) return outside * b.volume[slot];
  const double r = outside * b.volume[slot] / k;
  return k * (r - 1 - std::log(r));
}

/// NaN if a place is no number: std::max would pass over it.
double extentOf(const Bodies& b) {
  double extent = 0;
  for (int slot : b.slots) {
    const double around = b.areSpheres() ? b.parameters.cell.radius * b.restScale[slot] : 0;
    for (int v = 0; v < b.vertexCount(slot); ++v) {
      const double here = norm(b.vertex(slot, v)) + around;
      if (std::isnan(here)) return here;
      extent = std::max(extent, here);
    }
  }
  return extent;
}

std::string text(const Bounds& b) { return "from " + exactText(b.least) + " to " + exactText(b.most); }

CheckResult resultOf(const char* check, const std::string& expected, const std::string& actual, bool passed) {
  return judged({.check = check, .kind = "invariant", .expected = expected, .actual = actual, .field = check},
                passed, std::string("check.") + check + ": " + actual + "; expected " + expected);
}

}  // namespace

double measureEnergy(const Bodies& b) {
  double sum = 0;
  for (int slot : b.slots)
    sum += measureKineticEnergy(b, slot) + membraneEnergy(b, slot) + contentsEnergy(b, slot);
  return sum;
}

Vector measureMomentum(const Bodies& b) {
  Vector sum;
  for (int slot : b.slots)
    for (int v = 0; v < b.vertexCount(slot); ++v) sum += b.vertexMass[slot] * b.read(b.velocity, slot, v);
  return sum;
}

bool Invariants::areGiven(const CheckParameters& c) {
  return c.volume || c.extent || c.energy || c.momentum || c.endVolume || c.endRoundness || c.endOverlap ||
         !c.fails.empty();
}

// Both written so that what is no number is the worst there can be, and stays it.
void Invariants::raise(Extreme& most, double value, const World& world, std::optional<CellPath> cell) {
  if (most.seen && !(value > most.value) && !std::isnan(value)) return;
  most = {value, true, world.clock.step, cell};
}
void Invariants::lower(Extreme& least, double value, const World& world, std::optional<CellPath> cell) {
  if (least.seen && !(value < least.value) && !std::isnan(value)) return;
  least = {value, true, world.clock.step, cell};
}

void Invariants::observeVolumes(const World& world) {
  const Bodies& b = *world.bodies;
  const std::vector<double> rest = restVolumes(b);
  for (int cell = 0; cell < b.count; ++cell) {
    const int slot = b.slots[cell];
    const double scale = b.restScale[slot];
    const double volume =
        b.volume[slot] / (rest[b.blocks[slot / blockLanes].coarseness] * scale * scale * scale);
    lower(leastVolume_, volume, world, world.cells.path[cell]);
    raise(mostVolume_, volume, world, world.cells.path[cell]);
  }
}

void Invariants::observe(const World& world) {
  if (!world.bodies) return;
  const Bodies& b = *world.bodies;
  if (check_.volume) observeVolumes(world);
  if (check_.extent) raise(extent_, extentOf(b), world);
  if (check_.energy) raise(energy_, measureEnergy(b), world);
  if (check_.momentum) {
    const Vector now = measureMomentum(b);
    if (!momentum_) momentum_ = now;
    raise(stray_, norm(now - *momentum_), world);
  }
}

// Comparisons that fail for what is no number.
bool Invariants::holdSoFar() const {
  const auto most = [](const std::optional<double>& bound, const Extreme& e) {
    return !bound || e.value <= *bound;
  };
  const auto& volume = check_.volume;
  return (!volume || (leastVolume_.value >= volume->least && mostVolume_.value <= volume->most)) &&
         most(check_.extent, extent_) && most(check_.energy, energy_) && most(check_.momentum, stray_);
}

std::vector<CheckResult> Invariants::results(const World& end) const { return collect(&end); }
std::vector<CheckResult> Invariants::watched() const { return collect(nullptr); }

std::vector<CheckResult> Invariants::collect(const World* end) const {
  std::vector<CheckResult> all;
  const auto add = [&](const char* check, const std::string& expected, const std::string& actual,
                       const Extreme& worst, bool passed) {
    all.push_back(resultOf(check, expected, actual, passed));
    CheckResult& r = all.back();
    r.firstStep = worst.step;
    if (worst.cell) r.cell = worst.cell->text();
    if (passed) return;
    r.message += " at step " + std::to_string(worst.step);
    if (worst.cell) r.message += " of " + cellName(worst.cell->text());
  };
  const auto addBounds = [&](const char* check, const Bounds& bounds, const Extreme& least,
                             const Extreme& most) {
    const bool above = !(most.value <= bounds.most);
    add(check, text(bounds), text({least.value, most.value}), above ? most : least,
        least.value >= bounds.least && !above);
  };
  const auto addMost = [&](const char* check, const std::optional<double>& bound, const Extreme& most) {
    if (bound) add(check, "at most " + exactText(*bound), exactText(most.value), most, most.value <= *bound);
  };
  if (check_.volume) addBounds("volume", *check_.volume, leastVolume_, mostVolume_);
  addMost("extent", check_.extent, extent_);
  addMost("energy", check_.energy, energy_);
  addMost("momentum", check_.momentum, stray_);
  if (!end) return all;
  if (check_.endVolume) {
    Invariants last(check_);
    last.observeVolumes(*end);
    addBounds("end-volume", *check_.endVolume, last.leastVolume_, last.mostVolume_);
  }
  if (check_.endRoundness) {
    Extreme least;
    for (const CellMeasures& cell : measureCells(*end)) lower(least, cell.sphericity, *end, cell.path);
    add("end-roundness", "at least " + exactText(*check_.endRoundness), exactText(least.value), least,
        least.value >= *check_.endRoundness);
  }
  if (check_.endOverlap) {
    Extreme mean;
    raise(mean, measureMeanOverlap(*end), *end);
    addMost("end-overlap", check_.endOverlap, mean);
  }
  return all;
}

CheckResult stopsAsItMust(const std::vector<std::string>& fails, const std::string& failure) {
  std::vector<std::string> missing;
  for (const std::string& text : fails)
    if (failure.find(text) == failure.npos) missing.push_back(text);
  const std::string actual = failure.empty() ? "it ended well" : failure;
  return judged({.check = "fails",
                 .kind = "invariant",
                 .expected = fails.empty() ? "" : "stops and names " + join(fails),
                 .actual = actual},
                !fails.empty() && missing.empty(),
                "check.fails: the run should have stopped; " + actual + "; missing: " + join(missing));
}

}  // namespace morula
