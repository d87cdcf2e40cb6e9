
#include "observation/observation.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "base/maths.h"
#include "contacts/contacts.h"
#include "division/principal_axis.h"
#include "mesh/mesh_measures.h"
#include "observation/body_measures.h"
#include "observation/crumpling.h"
#include "physics/growth.h"
#include "state/pace.h"

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
  // Contacts are sorted by (a, b): each cell first meets cells before it and then cells behind it, both in rising
  // order.
  for (const auto& [a, b, area] : *contacts_) {
    contactsByCell_[next[a]++] = {b, area};
    contactsByCell_[next[b]++] = {a, area};
  }
  return *contacts_;
}

std::span<const Observation::Contact> Observation::contactsOf(int number) const {
  contacts();
  return std::span(contactsByCell_).subspan(firstContact_[number], firstContact_[number + 1] - firstContact_[number]);
}

double Observation::meshVolume(int meshLevel) const {
  if (meshVolumes_.empty())
    for (int i = 0; i <= static_cast<int>(world.bodies->coarser.size()); ++i)
      meshVolumes_.push_back(measureMeshVolume(*world.bodies, i));
  return meshVolumes_[meshLevel];
}

const EdgeFaces& Observation::flatEdges(int meshLevel) const {
  if (flatEdges_.empty())
    for (int i = 0; i <= static_cast<int>(world.bodies->coarser.size()); ++i) {
      const Mesh& mesh = world.bodies->meshAt(i).mesh;
      flatEdges_.push_back(findFlatEdges(mesh.vertices, mesh.faces));
    }
  return flatEdges_[meshLevel];
}

Point Observation::organismCentre() const {
  if (!organismCentre_) {
    Vector sum;
    double volume = 0;
    for (int slot : world.bodies->slots) {
      sum += world.bodies->volume[slot] * measureCentre(*world.bodies, slot);
      volume += world.bodies->volume[slot];
    }
    organismCentre_ = sum / volume;
  }
  return *organismCentre_;
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

const Point& Observation::centreOf(int number) const {
  if (centres_.empty())
    for (int slot : world.bodies->slots) centres_.push_back(measureCentre(*world.bodies, slot));
  return centres_[number];
}

double Observation::probe() const {
  const Bodies& b = *world.bodies;
  double volume = 0;
  for (const int slot : b.slots) volume += b.volume[slot];
  return 0.5 * cubeRoot(volume / static_cast<double>(b.slots.size()) * 3 / (4 * std::numbers::pi));
}

const Cavities& Observation::cavities() const {
  if (cavities_) return *cavities_;
  std::vector<Mesh> surfaces;
  for (const int slot : world.bodies->slots) surfaces.push_back(takeSurface(*world.bodies, slot));
  std::vector<MeshView> meshes;
  for (const Mesh& surface : surfaces) meshes.push_back({surface.vertices, surface.faces});
  cavities_ = meshes.empty() ? Cavities{} : measureCavities(meshes, probe());
  return *cavities_;
}

BodyUnit::BodyUnit(const Observation& observation, int slot)
    : observation_(observation), bodies_(*observation.world.bodies), slot_(slot) {}

double BodyUnit::getRestVolume() const {
  return measureRestVolume(bodies_, slot_, observation_.meshVolume(bodies_.blocks[slot_ / blockLanes].meshLevel));
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

ObservedCell::ObservedCell(const Observation& observation, int number) : observation_(observation), number_(number) {
  const Cells& cells = observation.world.cells;
  path = cells.path[number];
  state = cells.state[number];
  time = observation.time;
  lastCycle = cells.lastCycle[number];
  born = observation.world.lineage.entries[cells.entry[number]].born;
  pace = paceOf(observation.world, path, state);
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

std::span<const CellContext* const> ObservedCell::connected() const {
  if (!connected_) {
    connected_.emplace();
    const World& world = observation_.world;
    if (world.connections)
      for (const CellPath& other : partners(*world.connections, path))
        connected_->push_back(&observation_.cell(cellNumber(world.cells, other)));
  }
  return *connected_;
}

std::optional<Vector> ObservedCell::shell() const {
  const auto& bodies = observation_.world.bodies;
  if (!bodies || !bodies->parameters.shell) return {};
  if (bodies->parameters.shell->mesh) return {};
  const auto& [a, b, c] = bodies->parameters.shell->semiAxes;
  return Vector{a, b, c};
}

std::optional<Vector> ObservedCell::nearestShellNormal() const {
  const auto& bodies = observation_.world.bodies;
  if (!bodies || !bodies->parameters.shell || !bodies->parameters.shell->mesh) return {};
  return nearestPlane(bodies->parameters.shell->mesh->planes, physical()->getShape().centre).normal;
}

Point ObservedCell::organismCentre() const {
  return observation_.world.bodies ? observation_.organismCentre() : Point{};
}

const Vector* ObservedCell::inheritedPolarity() const {
  if (!observation_.world.polarities) return nullptr;
  const std::vector<PolarityRecord>& all = *observation_.world.polarities;
  for (CellPath cell = path; !cell.isEgg();) {
    cell = cell.mother();
    const auto at = std::ranges::lower_bound(all, cell, {}, &PolarityRecord::path);
    if (at != all.end() && at->path == cell) return &at->direction;
  }
  return nullptr;
}

std::span<const OtherCell> ObservedCell::otherCells() const {
  if (!others_) {
    others_.emplace();
    const int count = observation_.world.bodies ? static_cast<int>(observation_.world.cells.path.size()) : 0;
    for (int other = 0; other < count; ++other)
      if (other != number_)
        others_->push_back(
            {&observation_.cell(other), norm(observation_.centreOf(other) - observation_.centreOf(number_))});
  }
  return *others_;
}

double ObservedCell::shellShare() const {
  if (!observation_.world.bodies || !observation_.world.bodies->parameters.shell) return 0;
  return measureShellShare(physical()->getShape(), *observation_.world.bodies->parameters.shell);
}

std::optional<double> ObservedCell::surfaceDistance() const {
  if (!observation_.world.bodies || observation_.cavities().outside.empty()) return {};
  const Point& centre = observation_.centreOf(number_);
  double least = std::numeric_limits<double>::infinity();
  for (const Point& probe : observation_.cavities().outside)
    least = std::min(least, dot(probe - centre, probe - centre));
  return std::sqrt(least) - observation_.probe();
}

std::optional<ShellPlace> ObservedCell::placeInShell() const {
  const auto& bodies = observation_.world.bodies;
  if (!bodies || !bodies->parameters.shell) return {};
  return measurePlaceInShell(*bodies->parameters.shell, observation_.centreOf(number_));
}

double ObservedCell::elongation() const {
  if (!observation_.world.bodies) return 1;
  const BodyShape& shape = physical()->getShape();
  return shape.isBall ? 1 : extentRatio(shape.surface.vertices);
}

double ObservedCell::foldedShare() const {
  return observation_.world.bodies ? countFolded(observation_, *this).share() : 0;
}

double ObservedCell::compressedShare() const {
  return observation_.world.bodies ? countCompressed(observation_, *this).share() : 0;
}

double ObservedCell::size() const {
  return observation_.world.bodies ? sizeAtRest(*observation_.world.bodies, slot()) : 1;
}

double ObservedCell::sizeAtBirth() const {
  const auto& sizes = observation_.world.birthSizes;
  return sizes ? (*sizes)[number_].size : 0;
}

}  // namespace morula
