// Field by named field, never over raw memory: where a cell lies in it must not matter.
#include "simulation/hash.h"

#include <map>
#include <string>

#include "simulation/world.h"

namespace morula {

namespace {

void addPath(Hasher& h, const CellPath& p) { h.add(p.high()).add(p.low()).add(p.depth()); }

/// What a state's substances are called, looked up once: a large lineage has few states.
class StateTexts {
 public:
  explicit StateTexts(const BiologicalUnit& biology) : biology_(biology) {}
  const std::string& operator()(StateId state) {
    const auto [text, isNew] = texts_.try_emplace(state);
    if (isNew) text->second = biology_.describe(state);
    return text->second;
  }

 private:
  const BiologicalUnit& biology_;
  std::map<StateId, std::string> texts_;
};

/// Hashes one body after the other, and keeps the memory.
class BodyHasher {
 public:
  explicit BodyHasher(const Bodies& bodies) : bodies_(bodies) {}
  void add(Hasher& h, int slot) {
    h.field("vertex mass").add(bodies_.vertexMass[slot]);
    h.field("rest scale").add(bodies_.restScale[slot]);
    h.field("pressure constant").add(bodies_.pressureConstant[slot]);
    addVectors(h, "position", bodies_.position, slot);
    addVectors(h, "velocity", bodies_.velocity, slot);
    addVectors(h, "acceleration", bodies_.acceleration, slot);
  }

 private:
  void addVectors(Hasher& h, const char* name, const Reals& array, int slot) {
    column_.clear();
    for (int v = 0; v < bodies_.vertexCount(slot); ++v) {
      const Vector a = bodies_.read(array, slot, v);
      column_.insert(column_.end(), {a.x, a.y, a.z});
    }
    h.field(name).add(std::span<const double>(column_));
  }

  const Bodies& bodies_;
  std::vector<double> column_;  // one cell's vectors, one behind the other
};

Hash hashClock(const Clock& c) {
  Hasher h;
  return h.add(c.time).add(c.step).add(c.timeStep).add(c.epochTime).add(c.epochStep).digest();
}

std::vector<CellHash> hashCells(const World& world, StateTexts& stateText) {
  const Cells& cells = world.cells;
  std::optional<BodyHasher> body;
  if (world.bodies) body.emplace(*world.bodies);
  std::vector<CellHash> hashes;
  hashes.reserve(cells.path.size());
  for (std::size_t i = 0; i < cells.path.size(); ++i) {
    Hasher h;
    addPath(h, cells.path[i]);
    h.add(stateText(cells.state[i])).add(cells.lastCycle[i]).add(cells.growth[i]);
    if (body) body->add(h, world.bodies->slots[i]);
    hashes.push_back({cells.path[i], h.digest()});
  }
  return hashes;
}

Hash hashConnections(const World& world) {
  if (!world.connections) return {};
  Hasher h;
  h.field("connections").add(std::uint64_t{world.connections->history.size()});
  for (const ConnectionRecord& r : world.connections->history) {
    addPath(h, r.a);
    addPath(h, r.b);
    h.add(r.made).add(r.released).add(r.cause);
  }
  return h.digest();
}

Hash hashLineage(const World& world, StateTexts& stateText) {
  Hasher h;
  h.field("lineage").add(std::uint64_t{world.lineage.entries.size()});
  for (const LineageEntry& e : world.lineage.entries) {
    addPath(h, e.path);
    h.add(e.born).add(e.ended).add(e.bornStep).add(e.endedStep).add(static_cast<int>(e.fate));
    h.add(stateText(e.state));
  }
  return h.digest();
}

}  // namespace

Hash hashWhole(const StateHashes& parts) {
  Hasher h;
  h.field("clock").add(parts.clock).field("cells").add(std::uint64_t{parts.cells.size()});
  for (const CellHash& cell : parts.cells) h.add(cell.hash);
  return h.field("connections").add(parts.connections).field("lineage").add(parts.lineage).digest();
}

StateHashes hashState(const World& world) {
  StateTexts stateText(*world.biology);
  StateHashes parts{{},
                    hashClock(world.clock),
                    hashCells(world, stateText),
                    hashConnections(world),
                    hashLineage(world, stateText)};
  parts.whole = hashWhole(parts);
  return parts;
}

Hash hashLink(const std::optional<Hash>& before, std::uint64_t step, const Hash& state) {
  return Hasher().add(before.value_or(Hash{})).add(step).add(state).digest();
}

ChainLink nextLink(const std::optional<Hash>& before, const World& world) {
  ChainLink link{world.clock.step, {}, hashState(world)};
  link.hash = hashLink(before, link.step, link.state.whole);
  return link;
}

}  // namespace morula
