#include "golden/facts.h"

#include <algorithm>
#include <map>

#include "golden/number_text.h"

namespace morula {

namespace {

std::string nameOf(const CellPath& path) { return path.isEgg() ? "egg" : path.text(); }

/// Works out each state's text once: a large lineage has few states.
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

class Builder {
 public:
  std::vector<GoldenItem> items;

  void count(const char* name, std::uint64_t n) { items.push_back({"count", name, {std::to_string(n)}}); }

  void value(const std::string& when, const std::string& who, const char* what, std::uint64_t step,
             double v) {
    items.push_back({"value", when + '/' + who + '/' + what, {std::to_string(step), exactText(v)}});
  }

  /// What was not measured is 0 in a golden file.
  template <class Of>
  void values(const std::string& when, const std::string& who, std::uint64_t step, const Measured<Of>& m) {
    const auto rows = sampledMeasures<Of>();
    for (std::size_t i = 0; i < rows.size(); ++i)
      value(when, who, rows[i].name, step, m.values[i].value_or(0));
  }
};

void addCounts(Builder& to, const GoldenFacts& facts) {
  std::uint64_t alive = 0, divided = 0, died = 0;
  for (const LineageEntry& e : facts.lineage)
    ++(e.fate == Fate::alive ? alive : e.fate == Fate::divided ? divided : died);
  to.count("cells", alive);
  to.count("cells_ever", facts.lineage.size());
  to.count("divisions", divided);
  to.count("deaths", died);
  to.count("steps", facts.steps);
  if (facts.chain.size() > 1) to.count("hash_every", facts.chain[1].step - facts.chain[0].step);
}

void addLineage(Builder& to, std::vector<const LineageEntry*> entries, StateTexts& stateText) {
  std::sort(entries.begin(), entries.end(), [](auto* a, auto* b) { return a->path < b->path; });
  for (const LineageEntry* e : entries) {
    const bool alive = e->fate == Fate::alive;
    to.items.push_back({"cell",
                        nameOf(e->path),
                        {exactText(e->born), std::to_string(e->bornStep), alive ? "-" : exactText(e->ended),
                         alive ? "-" : std::to_string(e->endedStep), name(e->fate), stateText(e->state)}});
  }
}

/// One digest per generation, so that a difference still shows where it begins.
void addGenerations(Builder& to, std::vector<const LineageEntry*> entries, StateTexts& stateText) {
  std::sort(entries.begin(), entries.end(), [](auto* a, auto* b) {
    return a->path.depth() != b->path.depth() ? a->path.depth() < b->path.depth() : a->path < b->path;
  });
  for (std::size_t begin = 0; begin < entries.size();) {
    const int depth = entries[begin]->path.depth();
    Hasher hasher;
    std::size_t end = begin;
    for (; end < entries.size() && entries[end]->path.depth() == depth; ++end) {
      const LineageEntry& e = *entries[end];
      hasher.add(e.path.high())
          .add(e.path.low())
          .add(e.born)
          .add(e.bornStep)
          .add(name(e.fate))
          .add(stateText(e.state));
      if (e.fate != Fate::alive) hasher.add(e.ended).add(e.endedStep);
    }
    to.items.push_back(
        {"generation", std::to_string(depth), {std::to_string(end - begin), hasher.digest().text()}});
    begin = end;
  }
}

/// Four digits of each living cell's hash: they say which cells differ where the link does.
std::string cellDigits(const std::vector<CellHash>& cells) {
  std::string text;
  if (cells.size() > goldenCellLimit) return text;
  for (const CellHash& c : cells) text += c.hash.text().substr(28);
  return text;
}

void addChain(Builder& to, const std::vector<ChainLink>& chain) {
  std::size_t stride = 1;
  while (chain.size() / stride > goldenChainLimit) stride *= 2;
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (i % stride == 0 || i + 1 == chain.size())  // the last one vouches for all
      to.items.push_back({"step_hash",
                          std::to_string(chain[i].step),
                          {chain[i].hash.text(), cellDigits(chain[i].state.cells)}});
}

}  // namespace

GoldenData makeGoldenData(const GoldenFacts& facts) {
  Builder to;
  addCounts(to, facts);

  std::vector<const LineageEntry*> entries;
  for (const LineageEntry& e : facts.lineage) entries.push_back(&e);
  StateTexts stateText(facts.describe);
  const bool large = entries.size() > goldenLineageLimit;
  (large ? addGenerations : addLineage)(to, std::move(entries), stateText);

  for (const GoldenTimeStep& t : facts.timeSteps)
    to.items.push_back({"time_step", std::to_string(t.step), {exactText(t.time), exactText(t.timeStep)}});
  to.items.push_back({"bits", "solver", {facts.stateHash.text()}});
  addChain(to, facts.chain);
  for (const GoldenImage& image : facts.images)
    to.items.push_back({"image", image.name, {image.renderer, image.hash.text()}});
  for (const auto& [name, count] : facts.costs) to.items.push_back({"cost", name, {std::to_string(count)}});

  if (facts.mechanics) {
    for (const WorldMeasures& sample : facts.samples)
      if (sample.step < facts.end.step) to.values(exactText(sample.time), "organism", sample.step, sample);
    to.values("final", "organism", facts.end.step, facts.end);
    if (facts.cells.size() <= goldenCellLimit)
      for (const CellMeasures& c : facts.cells) to.values("final", nameOf(c.path), facts.end.step, c);
  }
  return {facts.scenario, facts.scenarioHash, facts.seed, std::move(to.items)};
}

}  // namespace morula
