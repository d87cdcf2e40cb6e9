#include "golden/facts.h"

#include <algorithm>
#include <map>

namespace morula {
namespace {

/// The texts of states, each described once: a large lineage has few states.
class StateTexts {
 public:
  explicit StateTexts(const std::function<std::string(StateId)>& describe) : describe_(describe) {}
  const std::string& operator()(StateId state) {
    const auto found = texts_.find(state);
    return found != texts_.end() ? found->second : texts_.emplace(state, describe_(state)).first->second;
  }

 private:
  const std::function<std::string(StateId)>& describe_;
  std::map<StateId, std::string> texts_;
};

using Items = std::vector<GoldenItem>;

template <class Of>
void addValues(Items& to, std::optional<double> time, const std::optional<CellPath>& cell, std::uint64_t step,
               const Measured<Of>& m) {
  const auto rows = sampledMeasures<Of>();
  for (std::size_t i = 0; i < rows.size(); ++i)
    to.push_back(GoldenValue{{time, cell, rows[i].name}, step, m.values[i]});
}

void addCounts(Items& to, const GoldenFacts& facts) {
  std::uint64_t alive = 0, divided = 0, died = 0;
  for (const LineageEntry& e : facts.lineage)
    ++(e.fate == Fate::alive ? alive : e.fate == Fate::divided ? divided : died);
  to.insert(to.end(),
            {GoldenCount{"cells", alive}, GoldenCount{"cells_ever", facts.lineage.size()},
             GoldenCount{"divisions", divided}, GoldenCount{"deaths", died}, GoldenCount{"steps", facts.steps}});
  if (facts.chain.size() > 1) to.push_back(GoldenCount{"hash_every", facts.chain[1].step - facts.chain[0].step});
}

void addLineage(Items& to, std::vector<const LineageEntry*> entries, StateTexts& stateText) {
  std::sort(entries.begin(), entries.end(), [](auto* a, auto* b) { return a->path < b->path; });
  for (const LineageEntry* e : entries) {
    GoldenCell cell{.path = e->path,
                    .born = e->born,
                    .bornStep = e->bornStep,
                    .ended = {},
                    .endedStep = {},
                    .fate = e->fate,
                    .state = {stateText(e->state)}};
    if (e->fate != Fate::alive) cell.ended = e->ended, cell.endedStep = e->endedStep;
    to.push_back(std::move(cell));
  }
}

/// Adds one digest per generation, so that a difference still shows the generation in which it begins.
void addGenerations(Items& to, std::vector<const LineageEntry*> entries, StateTexts& stateText) {
  std::sort(entries.begin(), entries.end(), [](auto* a, auto* b) {
    return a->path.depth() != b->path.depth() ? a->path.depth() < b->path.depth() : a->path < b->path;
  });
  for (std::size_t begin = 0; begin < entries.size();) {
    const int depth = entries[begin]->path.depth();
    Hasher hasher;
    std::size_t end = begin;
    for (; end < entries.size() && entries[end]->path.depth() == depth; ++end) {
      const LineageEntry& e = *entries[end];
      hasher.add(e.path.high()).add(e.path.low()).add(e.born).add(e.bornStep).add(name(e.fate)).add(stateText(e.state));
      if (e.fate != Fate::alive) hasher.add(e.ended).add(e.endedStep);
    }
    to.push_back(GoldenGeneration{static_cast<std::uint64_t>(depth), end - begin, hasher.digest()});
    begin = end;
  }
}

/// Returns four digits of each living cell's hash. They tell which cells differ if a link differs.
std::string cellDigits(const std::vector<CellHash>& cells) {
  std::string text;
  if (cells.size() > goldenCellLimit) return text;
  for (const CellHash& c : cells) text += c.hash.text().substr(28);
  return text;
}

void addChain(Items& to, const std::vector<ChainLink>& chain) {
  std::size_t stride = 1;
  while (chain.size() / stride > goldenChainLimit) stride *= 2;
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (i % stride == 0 || i + 1 == chain.size())  // the last link confirms all others
      to.push_back(GoldenLink{chain[i].step, chain[i].hash, {cellDigits(chain[i].state.cells)}});
}

}  // namespace

GoldenData makeGoldenData(const GoldenFacts& facts) {
  Items items;
  addCounts(items, facts);

  std::vector<const LineageEntry*> entries;
  for (const LineageEntry& e : facts.lineage) entries.push_back(&e);
  StateTexts stateText(facts.describe);
  const bool large = entries.size() > goldenLineageLimit;
  (large ? addGenerations : addLineage)(items, std::move(entries), stateText);

  items.insert(items.end(), facts.timeSteps.begin(), facts.timeSteps.end());
  items.push_back(GoldenBits{"solver", facts.stateHash});
  addChain(items, facts.chain);
  items.insert(items.end(), facts.images.begin(), facts.images.end());
  items.insert(items.end(), facts.costs.begin(), facts.costs.end());

  if (facts.mechanics) {
    for (const WorldMeasures& sample : facts.samples)
      if (sample.step < facts.end.step) addValues(items, sample.time, {}, sample.step, sample);
    addValues(items, {}, {}, facts.end.step, facts.end);
    if (facts.cells.size() <= goldenCellLimit)
      for (const CellMeasures& c : facts.cells) addValues(items, {}, c.path, facts.end.step, c);
  }
  items.insert(items.end(), facts.tables.begin(), facts.tables.end());
  return {facts.scenario, facts.scenarioHash, facts.seed, std::move(items)};
}

}  // namespace morula
