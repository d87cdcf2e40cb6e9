#include "check/invariants.h"

#include <cmath>

#include "files/text.h"
#include "observation/measures.h"
#include "yaml/numbers.h"

namespace morula {
namespace {

double valueOf(const char* name, const Observation& now) { return *measure<Observation>(name).get(now); }

/// Calls see(value, path) for each cell.
template <class See>
void forEachCell(const char* name, const Observation& now, const See& see) {
  const CellMeasure& row = measure<CellContext>(name);
  for (std::size_t i = 0; i < now.world.cells.path.size(); ++i) {
    const ObservedCell cell(now, static_cast<int>(i));
    see(*row.get(cell), cell.path);
  }
}

std::string text(const Bounds& b) { return "from " + exactText(b.least) + " to " + exactText(b.most); }

CheckResult resultOf(const char* check, const std::string& expected, const std::string& actual, bool passed) {
  return judged({.check = check, .kind = CheckKind::invariant, .expected = expected, .actual = actual, .field = check},
                passed, std::string("check.") + check + ": " + actual + "; expected " + expected);
}

}  // namespace

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

void Invariants::observeVolumes(const Observation& now) {
  forEachCell("volume_over_mesh", now, [&](double volume, const CellPath& cell) {
    lower(minVolume_, volume, now.world, cell);
    raise(maxVolume_, volume, now.world, cell);
  });
}

void Invariants::observe(const World& world) {
  if (!world.bodies) return;
  const Observation now(world);
  if (check_.volume) observeVolumes(now);
  if (check_.extent) raise(extent_, valueOf("extent", now), world);
  if (check_.energy) raise(energy_, valueOf("energy", now), world);
  if (check_.momentum) {
    const Vector momentum{valueOf("momentum_x", now), valueOf("momentum_y", now), valueOf("momentum_z", now)};
    if (!momentum_) momentum_ = momentum;
    raise(stray_, norm(momentum - *momentum_), world);
  }
}

// Comparisons that fail for what is no number.
bool Invariants::holdSoFar() const {
  const auto most = [](const std::optional<double>& bound, const Extreme& e) { return !bound || e.value <= *bound; };
  const auto& volume = check_.volume;
  return (!volume || (minVolume_.value >= volume->least && maxVolume_.value <= volume->most)) &&
         most(check_.extent, extent_) && most(check_.energy, energy_) && most(check_.momentum, stray_);
}

std::vector<CheckResult> Invariants::results(const World& end) const { return collect(&end); }
std::vector<CheckResult> Invariants::watched() const { return collect(nullptr); }

std::vector<CheckResult> Invariants::collect(const World* end) const {
  std::vector<CheckResult> all;
  const auto add = [&](const char* check, const std::string& expected, const std::string& actual, const Extreme& worst,
                       bool passed) {
    all.push_back(resultOf(check, expected, actual, passed));
    CheckResult& r = all.back();
    r.firstStep = worst.step;
    if (worst.cell) r.cell = worst.cell->text();
    if (passed) return;
    r.message += " at step " + std::to_string(worst.step);
    if (worst.cell) r.message += " of " + cellName(worst.cell->text());
  };
  const auto addBounds = [&](const char* check, const Bounds& bounds, const Extreme& least, const Extreme& most) {
    const bool above = !(most.value <= bounds.most);
    add(check, text(bounds), text({least.value, most.value}), above ? most : least,
        least.value >= bounds.least && !above);
  };
  const auto addMost = [&](const char* check, const std::optional<double>& bound, const Extreme& most) {
    if (bound) add(check, "at most " + exactText(*bound), exactText(most.value), most, most.value <= *bound);
  };
  if (check_.volume) addBounds("volume", *check_.volume, minVolume_, maxVolume_);
  addMost("extent", check_.extent, extent_);
  addMost("energy", check_.energy, energy_);
  addMost("momentum", check_.momentum, stray_);
  if (!end) return all;
  const Observation now(*end);
  if (check_.endVolume) {
    Invariants last(check_);
    last.observeVolumes(now);
    addBounds("end-volume", *check_.endVolume, last.minVolume_, last.maxVolume_);
  }
  if (check_.endRoundness) {
    Extreme least;
    if (end->bodies)
      forEachCell("sphericity", now,
                  [&](double roundness, const CellPath& cell) { lower(least, roundness, *end, cell); });
    add("end-roundness", "at least " + exactText(*check_.endRoundness), exactText(least.value), least,
        least.value >= *check_.endRoundness);
  }
  if (check_.endOverlap) {
    Extreme mean;
    raise(mean, end->bodies ? valueOf("mean_overlap", now) : 0, *end);
    addMost("end-overlap", check_.endOverlap, mean);
  }
  return all;
}

CheckResult stopsAsItMust(const std::vector<std::string>& fails, const std::string& failure) {
  std::vector<std::string> missing;
  for (const std::string& text : fails)
    if (failure.find(text) == failure.npos) missing.push_back(text);
  const std::string actual = failure.empty() ? "the run ended well" : failure;
  return judged({.check = "fails",
                 .kind = CheckKind::invariant,
                 .expected = fails.empty() ? "" : "stops and names " + join(fails),
                 .actual = actual},
                !fails.empty() && missing.empty(),
                "check.fails: the run should have stopped; " + actual + "; missing: " + join(missing));
}

}  // namespace morula
