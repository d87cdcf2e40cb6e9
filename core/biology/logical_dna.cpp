#include "biology/logical_dna.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "biology/substances.h"

namespace morula {

namespace {

constexpr StateId unknown = std::numeric_limits<StateId>::max();

using Substances = std::vector<SubstanceId>;  // sorted, each once

/// A state and all that the simulator will ask about it.
struct State {
  Substances substances;
  double cycleLength = 0;
  bool divides = false, dies = false;
  double growth = 0, connecting = 0;
  StateId next = unknown;                                // after a cell cycle
  std::array<StateId, 2> daughter = {unknown, unknown};  // A, B
};

/// One gene, as seen from the input that it waits for: active if the other inputs are there too, and no
/// repressor.
struct WaitingGene {
  SubstanceId product = 0;
  Substances otherInputs;
  Substances repressors;
};

class LogicalDna final : public BiologicalUnit {
 public:
  LogicalDna(const Dna& dna, const CycleParameters& cycle);

  StateId startState() const override { return start_; }
  double cycleLength(StateId state) const override { return states_[state].cycleLength; }
  StateId runCellCycle(const CellContext& cell) override;
  bool wantsToDivide(const CellContext& cell) const override { return states_[cell.state].divides; }
  bool wantsToDie(const CellContext& cell) const override { return states_[cell.state].dies; }
  double wantsToGrow(const CellContext& cell) const override { return states_[cell.state].growth; }
  double wantsToConnect(const CellContext& cell) const override { return states_[cell.state].connecting; }
  StateId daughterState(StateId mother, bool b) override;
  std::string describe(StateId state) const override;
  StateId stateOf(const std::string& description) override;

 private:
  StateId intern(Substances substances);
  Substances runGenes(const Substances& present);
  void readPace(const Dna& dna, const CycleParameters& cycle);
  void readGenes(const Dna& dna);

  std::vector<std::string> names_;
  std::vector<double> pace_;  // cycle length by substance; infinite where it says nothing
  double length_;             // cycle length of all other states
  std::vector<std::vector<WaitingGene>> waiting_;  // by the substance that they wait for
  std::vector<bool> isPresent_;                    // by substance; all false between calls
  // The substances that act; `unknown` for those that this DNA does not mention.
  SubstanceId divide_, die_, a_, b_, grow_, shrink_, connect_, release_;

  std::vector<State> states_;
  std::map<Substances, StateId> ids_;
  StateId start_ = 0;
};

LogicalDna::LogicalDna(const Dna& dna, const CycleParameters& cycle)
    : names_(dna.substances), length_(cycle.length), isPresent_(dna.substances.size(), false) {
  const auto find = [&](const std::string& name) { return findSubstance(dna, name).value_or(unknown); };
  divide_ = find(substance::divide), die_ = find(substance::die);
  a_ = find(substance::a), b_ = find(substance::b);
  grow_ = find(substance::grow), shrink_ = find(substance::shrink);
  connect_ = find(substance::connect), release_ = find(substance::release);
  MORULA_CHECK(a_ != unknown && b_ != unknown, "DNA comes from parseDna, which knows A and B");
  readPace(dna, cycle);
  readGenes(dna);
  start_ = intern(dna.start);
}

void LogicalDna::readPace(const Dna& dna, const CycleParameters& cycle) {
  MORULA_CHECK(cycle.length > 0, "time between cell cycles");
  pace_.assign(names_.size(), std::numeric_limits<double>::infinity());
  for (const auto& [name, length] : cycle.perSubstance) {
    MORULA_CHECK(length > 0, "time between cell cycles");
    const auto id = findSubstance(dna, name);
    if (!id) {
      const std::string meant = closest(name, names_);
      throw InputError("cycle: the DNA has no substance '" + name + "'; " +
                       (meant.empty() ? "name one that it produces" : "did you mean '" + meant + "'?"));
    }
    pace_[*id] = length;
  }
}

void LogicalDna::readGenes(const Dna& dna) {
  std::vector<std::size_t> readers(names_.size(), 0);
  for (const Gene& gene : dna.genes)
    for (SubstanceId input : gene.inputs) ++readers[input];
  waiting_.resize(names_.size());
  for (const Gene& gene : dna.genes) {
    const auto rarest = std::ranges::min_element(gene.inputs, {}, [&](SubstanceId s) { return readers[s]; });
    MORULA_CHECK(rarest != gene.inputs.end(), "a gene has at least one input");
    WaitingGene entry{gene.product, {}, gene.repressors};
    std::ranges::copy_if(gene.inputs, std::back_inserter(entry.otherInputs),
                         [&](SubstanceId s) { return s != *rarest; });
    waiting_[*rarest].push_back(std::move(entry));
  }
}

StateId LogicalDna::intern(Substances substances) {
  const auto [place, isNew] = ids_.try_emplace(substances, static_cast<StateId>(states_.size()));
  if (!isNew) return place->second;
  const auto has = [&](SubstanceId s) { return std::ranges::binary_search(substances, s); };
  State state;
  state.cycleLength = std::numeric_limits<double>::infinity();
  for (SubstanceId s : substances) state.cycleLength = std::min(state.cycleLength, pace_[s]);
  if (state.cycleLength == std::numeric_limits<double>::infinity()) state.cycleLength = length_;
  // A daughter inherits `divide` with the rest of its mother's state. It is a command that has been obeyed:
  // only what the daughter's own next cycle produces counts.
  const bool isNewborn = has(a_) || has(b_);
  state.divides = has(divide_) && !isNewborn;
  state.dies = has(die_);
  state.growth = has(grow_) - has(shrink_);
  state.connecting = has(connect_) - has(release_);
  state.substances = std::move(substances);
  states_.push_back(std::move(state));
  return place->second;
}

Substances LogicalDna::runGenes(const Substances& present) {
  Substances products;
  for (SubstanceId s : present) isPresent_[s] = true;
  const auto isThere = [&](SubstanceId s) -> bool { return isPresent_[s]; };
  for (SubstanceId s : present)
    for (const WaitingGene& gene : waiting_[s])
      if (std::ranges::all_of(gene.otherInputs, isThere) && std::ranges::none_of(gene.repressors, isThere))
        products.push_back(gene.product);
  for (SubstanceId s : present) isPresent_[s] = false;
  std::ranges::sort(products);
  products.erase(std::unique(products.begin(), products.end()), products.end());
  return products;
}

StateId LogicalDna::runCellCycle(const CellContext& cell) {
  if (states_[cell.state].next == unknown) {
    const StateId next = intern(runGenes(states_[cell.state].substances));  // may move states_
    states_[cell.state].next = next;
  }
  return states_[cell.state].next;
}

StateId LogicalDna::daughterState(StateId mother, bool b) {
  if (states_[mother].daughter[b] == unknown) {
    Substances substances = states_[mother].substances;
    const SubstanceId asymmetry = b ? b_ : a_;
    const auto place = std::ranges::lower_bound(substances, asymmetry);
    if (place == substances.end() || *place != asymmetry) substances.insert(place, asymmetry);
    const StateId daughter = intern(std::move(substances));
    states_[mother].daughter[b] = daughter;
  }
  return states_[mother].daughter[b];
}

std::string LogicalDna::describe(StateId state) const {
  std::string text;
  for (SubstanceId s : states_[state].substances) text += (text.empty() ? "" : " ") + names_[s];
  return text;
}

StateId LogicalDna::stateOf(const std::string& description) {
  Substances substances;
  for (std::string_view rest = description; !rest.empty();) {
    const std::string word(rest.substr(0, rest.find(' ')));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    const auto at = std::ranges::lower_bound(names_, word);
    if (at == names_.end() || *at != word) throw InputError("the DNA has no substance '" + word + "'");
    substances.push_back(static_cast<SubstanceId>(at - names_.begin()));
  }
  if (!std::ranges::is_sorted(substances, std::ranges::less_equal()))
    throw InputError("a state names its substances once each, sorted; '" + description + "' does not");
  return intern(std::move(substances));
}

}  // namespace

std::unique_ptr<BiologicalUnit> makeLogicalDna(const Dna& dna, const CycleParameters& cycle) {
  return std::make_unique<LogicalDna>(dna, cycle);
}

}  // namespace morula
