#include "simulation/observation.h"

#include <algorithm>
#include <numeric>

#include "mesh/measures.h"
#include "simulation/body_measures.h"

namespace morula {

Observation::Observation(const World& w, double t) : world{w}, time{t} {}
Observation::Observation(const World& w) : Observation(w, w.clock.time) {}
Observation::~Observation() = default;

const CellContext& Observation::cell(int number) const {
  cells_.resize(world.cells.path.size());
  std::unique_ptr<ObservedCell>& kept = cells_[number];
  if (!kept) kept = std::make_unique<ObservedCell>(*this, number);
  return *kept;
}

const std::vector<ContactArea>& Observation::contacts() const {
  if (contacts_) return *contacts_;
  contacts_.emplace();
  if (world.contacts) {
    *contacts_ = measureContactAreas(*world.contacts, *world.bodies);
    ++measured_.contacts;
  }
  firstContact_.assign(world.cells.path.size() + 1, 0);
  for (const ContactArea& touch : *contacts_) ++firstContact_[touch.a + 1], ++firstContact_[touch.b + 1];
  std::partial_sum(firstContact_.begin(), firstContact_.end(), firstContact_.begin());
  contactsByCell_.resize(2 * contacts_->size());
  std::vector<int> next(firstContact_.begin(), firstContact_.end() - 1);
  // By (a, b): each cell meets those before it first, and then those behind it, both in rising order.
  for (const auto& [a, b, area] : *contacts_) {
    contactsByCell_[next[a]++] = {b, area};
    contactsByCell_[next[b]++] = {a, area};
  }
  return *contacts_;
}

std::span<const Observation::Contact> Observation::contactsOf(int number) const {
  contacts();
  return std::span(contactsByCell_)
      .subspan(firstContact_[number], firstContact_[number + 1] - firstContact_[number]);
}

double Observation::meshVolume(int meshLevel) const {
  if (meshVolumes_.empty())
    for (int i = 0; i <= static_cast<int>(world.bodies->coarser.size()); ++i)
      meshVolumes_.push_back(measureMeshVolume(*world.bodies, i));
  return meshVolumes_[meshLevel];
}

const DivisionRecord* Observation::divisionOf(const CellPath& mother) const {
  const auto& all = world.divisions;
  const auto pathOf = [&](std::uint32_t i) { return all[i].path; };
  if (divisionByPath_.size() != all.size()) {
    divisionByPath_.resize(all.size());
    std::iota(divisionByPath_.begin(), divisionByPath_.end(), 0u);
    std::ranges::sort(divisionByPath_, {}, pathOf);
  }
  const auto at = std::ranges::lower_bound(divisionByPath_, mother, {}, pathOf);
  return at != divisionByPath_.end() && all[*at].path == mother ? &all[*at] : nullptr;
}

BodyUnit::BodyUnit(const Observation& observation, int slot)
    : observation_(observation), bodies_(*observation.world.bodies), slot_(slot) {}

double BodyUnit::getRestVolume() const {
  return measureRestVolume(bodies_, slot_,
                           observation_.meshVolume(bodies_.blocks[slot_ / blockLanes].meshLevel));
}

double BodyUnit::getMeshVolume() const {
  const double scale = bodies_.restScale[slot_];
  return observation_.meshVolume(bodies_.blocks[slot_ / blockLanes].meshLevel) * scale * scale * scale;
}

const BodyShape& BodyUnit::getShape() const {
  if (!shape_) {
    shape_ = measureShape(bodies_, slot_);
    ++observation_.measured_.shapes;
  }
  return *shape_;
}

ObservedCell::ObservedCell(const Observation& observation, int number)
    : observation_(observation), number_(number) {
  const Cells& cells = observation.world.cells;
  path = cells.path[number];
  state = cells.state[number];
  time = observation.time;
  lastCycle = cells.lastCycle[number];
  born = observation.world.lineage.entries[cells.entry[number]].born;
}

std::string ObservedCell::substances() const { return observation_.world.biology->describe(state); }

const PhysicalUnit* ObservedCell::physical() const {
  if (!observation_.world.bodies) return nullptr;
  if (!body_) body_.emplace(observation_, slot());
  return &*body_;
}

std::span<const Neighbour> ObservedCell::neighbours() const {
  if (!neighbours_) {
    neighbours_.emplace();
    for (const auto& [other, area] : observation_.contactsOf(number_))
      neighbours_->push_back({&observation_.cell(other), area});
  }
  return *neighbours_;
}

const CellContext* ObservedCell::sister() const {
  if (path.isEgg()) return nullptr;
  const CellPath sister = path.mother().daughter(!path.letter(path.depth() - 1));
  const int number = cellNumber(observation_.world.cells, sister);
  return number < 0 ? nullptr : &observation_.cell(number);
}

const DivisionRecord* ObservedCell::motherDivision() const {
  return path.isEgg() ? nullptr : observation_.divisionOf(path.mother());
}

const DivisionRecord* ObservedCell::grandmotherDivision() const {
  return path.depth() < 2 ? nullptr : observation_.divisionOf(path.mother().mother());
}

double ObservedCell::shellShare() const {
  if (!observation_.world.bodies || !observation_.world.bodies->parameters.shell) return 0;
  return measureShellShare(physical()->getShape(), *observation_.world.bodies->parameters.shell);
}

}  // namespace morula
