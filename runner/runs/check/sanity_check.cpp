#include "check/sanity_check.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "contacts/contacts.h"
#include "mesh/mesh_measures.h"
#include "observation/body_measures.h"
#include "observation/energy.h"
#include "observation/sanity.h"
#include "yaml/numbers.h"

namespace morula {
namespace {

/// [1] Max gain over the energy at the start: automatic steps keep energy to 0.5 %, steps just below the limit of
/// stability to a few per cent.
constexpr double maxGain = 0.05;
/// [1] Noise over the energy that contents hold at rest: the rounding of a scene that begins with next to no energy.
constexpr double energyNoise = 0.01;

Box boxOf(const World& world, int cell) {
  const int slot = world.bodies->slots[cell];
  Box box = measureBox(takeSurface(*world.bodies, slot).vertices);
  const double reach = world.contacts->radius[slot];
  const Vector around{reach, reach, reach};
  return {box.low - around, box.high + around};
}

bool meet(const Box& a, const Box& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y && a.low.z < b.high.z &&
         b.low.z < a.high.z;
}

/// False only if no two cells reach each other.
bool mayTouch(const World& world) {
  if (!world.contacts) return false;
  std::vector<Box> boxes;
  for (int cell = 0; cell < world.bodies->count; ++cell) boxes.push_back(boxOf(world, cell));
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (meet(boxes[i], boxes[j])) return true;
  return false;
}

/// False where cells may touch by a law whose forces have no energy, or stick, which leaves less than nothing.
bool keepsEnergy(const World& world) {
  if (!world.contacts || world.bodies->areSpheres()) return !mayTouch(world);
  return world.contacts->parameters.law == ContactLaw::pair || !mayTouch(world);
}

/// True if measureEnergy sees all that there is at the start, and nothing adds to it: growth, crawling and what
/// connects later add energy, and a shell moves what it stops.
bool isClosed(const World& start) {
  if (!start.bodies) return false;
  const PhysicsParameters& p = start.bodies->parameters;
  const bool boundless = p.pressure.outside == 0 && p.pressure.constant > 0;  // contents without a rest
  return start.bodies->model().hasMembrane && !p.shell && !p.growth && !boundless && !start.connections &&
         !p.motility && keepsEnergy(start);
}

bool sticksBySubstances(const World& world) {
  return world.contacts && world.contacts->parameters.adhesion && !world.contacts->parameters.adhesion->pairs.empty();
}

/// [cell] What each holds.
std::vector<std::string> statesOf(const World& world) {
  std::vector<std::string> states;
  for (const StateId state : world.cells.state) states.push_back(world.biology->describe(state));
  return states;
}

std::string boundsOf(const SanityMeasure& m) {
  if (m.least > 0) return "from " + exactText(m.least) + " to " + exactText(m.most);
  return "at most " + exactText(m.most);
}

CheckResult resultOf(const SanityMeasure& m, const World& end, const CheckParameters& check) {
  const std::string name = nameOf(m.kind);
  const bool below = m.kind == SanityKind::overlap && m.value == 0;
  return judged({.check = "sanity " + name,
                 .kind = CheckKind::sanity,
                 .expected = boundsOf(m),
                 .actual = below ? "below " + exactText(m.most) : exactText(m.value),
                 .tolerance = check.sane ? "exact" : "none, for " + check.because,
                 .firstStep = end.clock.step,
                 .cell = m.cell ? std::optional(m.cell->text()) : std::nullopt,
                 .field = name},
                m.holds() || !check.sane,
                "not sane at the end: " + describe(m, end) +
                    "; if this end is intended, write check: {sane: false, because: \"why\"}");
}

/// A scene that says it is not sane and is.
CheckResult needlessExcuse(const CheckParameters& check) {
  return judged({.check = "sanity because",
                 .kind = CheckKind::sanity,
                 .expected = "not sane, because " + check.because,
                 .actual = "sane",
                 .field = "sane"},
                false, "check.sane is false, but the end is within all bounds; remove check.sane and check.because");
}

}  // namespace

SanityCheck::SanityCheck(const World& start) : cells_(start.cells.path), states_(statesOf(start)) {
  if (!isClosed(start)) return;
  const Bodies& b = *start.bodies;
  const Energy energy = measureEnergy(start);
  energy_ = energy.total();
  double atRest = 0;
  for (int slot : b.slots) atRest += b.parameters.pressure.outside * measureRestVolume(b, slot);
  energyScale_ = std::max(energy.total() - 2 * energy.adhesion, energyNoise * atRest);
}

std::vector<CheckResult> SanityCheck::results(const World& end, const CheckParameters& check, bool held) const {
  std::vector<SanityMeasure> measures = measureSanity(end);
  const bool finite = !measures.empty() && measures[0].holds();
  if (energy_ && finite && end.cells.path == cells_ && (!sticksBySubstances(end) || statesOf(end) == states_)) {
    const double gain = (measureEnergy(end).total() - *energy_) / energyScale_;
    measures.push_back({SanityKind::energy, gain, -INFINITY, maxGain, {}, {}});
  }
  std::vector<CheckResult> all;
  for (const SanityMeasure& m : measures) all.push_back(resultOf(m, end, check));
  const bool sane = std::all_of(measures.begin(), measures.end(), [](const SanityMeasure& m) { return m.holds(); });
  if (!measures.empty() && held && !check.sane && sane) all.push_back(needlessExcuse(check));
  return all;
}

}  // namespace morula
