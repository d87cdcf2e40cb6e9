#include "biology/logical_dna.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "biology/sense.h"
#include "biology/substance_pattern.h"
#include "biology/substances.h"

namespace morula {
namespace {

constexpr StateId unknown = std::numeric_limits<StateId>::max();

using Substances = std::vector<SubstanceId>;  // sorted, each once

/// A state with everything that follows from its substances.
struct State {
  Substances substances;
  double cycleLength = 0;
  bool divides = false, dies = false;
  double growth = 0, connecting = 0;
  StateId next = unknown;                                // after a cell cycle
  std::array<StateId, 2> daughter = {unknown, unknown};  // A, B
  // Only if the DNA has senses; bit i is for sense number i
  std::uint64_t sensed = 0;                                      // senses whose substances the state holds
  std::uint64_t counted = 0;                                     // senses that count its cell [SenseParameters::of]
  std::vector<std::pair<std::uint64_t, StateId>> nextOnSensing;  // after a cell cycle, by the bits sensed in it
};

constexpr std::size_t maxSenses = 64;

/// One sense, and the substance that the simulator inserts for it.
struct Sense {
  SenseParameters parameters;
  SubstanceId substance;
};

/// One gene, filed under one of its inputs. If that input is present, the gene is active if the other inputs are, too,
/// and no repressor is.
struct WaitingGene {
  std::string name;
  bool isOn = true;
  SubstanceId product = 0;
  Substances otherInputs;
  Substances repressors;
};

class LogicalDna final : public BiologicalUnit {
 public:
  LogicalDna(const Dna& dna, const CycleParameters& cycle, std::span<const SenseParameters> senses);

  StateId startState() const override { return start_; }
  double cycleLength(StateId state) const override { return states_[state].cycleLength; }
  bool wantsToRunCellCycle(const CellContext& cell) const override {
    return BiologicalUnit::wantsToRunCellCycle(cell) && !(divisionSize_ && waitsForSize(cell));
  }
  StateId runCellCycle(const CellContext& cell) override { return nextState(cell); }
  bool wantsToDivide(const CellContext& cell) const override { return states_[cell.state].divides; }
  bool wantsToDie(const CellContext& cell) const override { return states_[cell.state].dies; }
  double wantsToGrow(const CellContext& cell) const override { return states_[cell.state].growth; }
  double wantsToConnect(const CellContext& cell) const override { return states_[cell.state].connecting; }
  StateId daughterState(StateId mother, bool b) override;
  std::string describe(StateId state) const override;
  StateId stateOf(const std::string& description) override;
  void setGene(const std::string& name, bool on) override;

 private:
  StateId intern(Substances substances) const;
  Substances runGenes(const Substances& present) const;
  StateId nextState(const CellContext& cell) const;
  std::uint64_t sense(const CellContext& cell) const;
  StateId nextOnSensing(StateId state, std::uint64_t sensed) const;
  Substances withoutSensed(const Substances& substances) const;
  bool waitsForSize(const CellContext& cell) const;
  double cycleLengthOf(const Substances& substances, bool isNewborn) const;
  void readPace(const CycleParameters& cycle);
  std::vector<double> paceBySubstance(const std::map<std::string, double>& lengths) const;
  void readGenes(const Dna& dna);
  void readSenses(const Dna& dna, std::span<const SenseParameters> senses);

  std::vector<std::string> names_;
  std::vector<double> pace_;       // cycle length by substance; infinite: none given
  std::vector<double> firstPace_;  // time to the first cycle, by a substance that genes will make; empty: none given
  double length_;                  // cycle length of all other states
  std::optional<DivisionSize> divisionSize_;
  std::vector<Sense> senses_;
  std::vector<std::vector<WaitingGene>> waiting_;  // by the input under which they are filed
  mutable std::vector<bool> isPresent_;            // by substance; all false between calls
  // The substances with an effect; `unknown` for those that this DNA does not mention.
  SubstanceId divide_, die_, a_, b_, grow_, shrink_, connect_, release_;

  // All states that have occurred so far; mutable, because any call with a new state adds it.
  mutable std::vector<State> states_;
  mutable std::map<Substances, StateId> ids_;
  StateId start_ = 0;
};

LogicalDna::LogicalDna(const Dna& dna, const CycleParameters& cycle, std::span<const SenseParameters> senses)
    : names_(dna.substances),
      length_(cycle.length),
      divisionSize_(cycle.divisionSize),
      isPresent_(dna.substances.size(), false) {
  const auto find = [&](const std::string& name) { return findSubstance(dna, name).value_or(unknown); };
  divide_ = find(substance::divide), die_ = find(substance::die);
  a_ = find(substance::a), b_ = find(substance::b);
  grow_ = find(substance::grow), shrink_ = find(substance::shrink);
  connect_ = find(substance::connect), release_ = find(substance::release);
  MORULA_CHECK(a_ != unknown && b_ != unknown, "DNA comes from parseDna, which knows A and B");
  readPace(cycle);
  readGenes(dna);
  readSenses(dna, senses);
  start_ = intern(dna.start);
}

void LogicalDna::readPace(const CycleParameters& cycle) {
  MORULA_CHECK(cycle.length > 0, "time between cell cycles");
  pace_ = paceBySubstance(cycle.perSubstance);
  if (!cycle.atBirth.empty()) firstPace_ = paceBySubstance(cycle.atBirth);
}

/// Returns for each substance the shortest of the lengths whose names or patterns fit.
std::vector<double> LogicalDna::paceBySubstance(const std::map<std::string, double>& lengths) const {
  std::vector<double> pace(names_.size(), std::numeric_limits<double>::infinity());
  for (const auto& [pattern, length] : lengths) {
    MORULA_CHECK(length > 0, "time between cell cycles");
    bool isMeant = false;
    for (std::size_t s = 0; s < names_.size(); ++s)
      if (fits(pattern, names_[s])) pace[s] = std::min(pace[s], length), isMeant = true;
    if (isMeant) continue;
    const std::string meant = closest(pattern, names_);
    throw InputError::at("cycle", ": the DNA has no substance '" + pattern + "'; " +
                                      (meant.empty() ? "name one that it produces" : "did you mean '" + meant + "'?"));
  }
  return pace;
}

void LogicalDna::readSenses(const Dna& dna, std::span<const SenseParameters> senses) {
  if (senses.size() > maxSenses)
    throw InputError::at("senses",
                         ": " + std::to_string(senses.size()) + " of them; give at most " + std::to_string(maxSenses));
  for (const SenseParameters& parameters : senses) {
    const auto id = findSubstance(dna, parameters.substance);
    if (!id)
      throw InputError::at(
          "senses", ": no gene reads '" + parameters.substance + "'; write a gene that reads it, or remove this");
    senses_.push_back({parameters, *id});
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
    WaitingGene entry{gene.name, true, gene.product, {}, gene.repressors};
    std::ranges::copy_if(gene.inputs, std::back_inserter(entry.otherInputs),
                         [&](SubstanceId s) { return s != *rarest; });
    waiting_[*rarest].push_back(std::move(entry));
  }
}

double LogicalDna::cycleLengthOf(const Substances& substances, bool isNewborn) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double length = infinity;
  if (isNewborn && !firstPace_.empty())
    for (SubstanceId s : runGenes(withoutSensed(substances))) length = std::min(length, firstPace_[s]);
  if (length < infinity) return length;
  for (SubstanceId s : substances) length = std::min(length, pace_[s]);
  return length < infinity ? length : length_;
}

StateId LogicalDna::intern(Substances substances) const {
  const auto [place, isNew] = ids_.try_emplace(substances, static_cast<StateId>(states_.size()));
  if (!isNew) return place->second;
  const auto has = [&](SubstanceId s) { return std::ranges::binary_search(substances, s); };
  State state;
  // A daughter inherits `divide` with the rest of its mother's state, but that division has been made: only a `divide`
  // from the daughter's own next cycle counts.
  const bool isNewborn = has(a_) || has(b_);
  state.cycleLength = cycleLengthOf(substances, isNewborn);
  state.divides = has(divide_) && !isNewborn;
  state.dies = has(die_);
  state.growth = has(grow_) - has(shrink_);
  state.connecting = has(connect_) - has(release_);
  for (std::size_t i = 0; i < senses_.size(); ++i) {
    const auto counts = [&](SubstanceId s) { return fits(senses_[i].parameters.of, names_[s]); };
    state.sensed |= std::uint64_t{has(senses_[i].substance)} << i;
    state.counted |= std::uint64_t{std::ranges::any_of(substances, counts)} << i;
  }
  state.substances = std::move(substances);
  states_.push_back(std::move(state));
  return place->second;
}

Substances LogicalDna::runGenes(const Substances& present) const {
  Substances products;
  for (SubstanceId s : present) isPresent_[s] = true;
  const auto isThere = [&](SubstanceId s) -> bool { return isPresent_[s]; };
  for (SubstanceId s : present)
    for (const WaitingGene& gene : waiting_[s])
      if (gene.isOn && std::ranges::all_of(gene.otherInputs, isThere) && std::ranges::none_of(gene.repressors, isThere))
        products.push_back(gene.product);
  for (SubstanceId s : present) isPresent_[s] = false;
  std::ranges::sort(products);
  products.erase(std::unique(products.begin(), products.end()), products.end());
  return products;
}

StateId LogicalDna::nextState(const CellContext& cell) const {
  if (!senses_.empty()) return nextOnSensing(cell.state, sense(cell));
  if (states_[cell.state].next == unknown) {
    const StateId next = intern(runGenes(states_[cell.state].substances));  // may move states_
    states_[cell.state].next = next;
  }
  return states_[cell.state].next;
}

/// Returns the bits of what the cell perceives now. Its state holds the bits of its, or its mother's, last cycle.
std::uint64_t LogicalDna::sense(const CellContext& cell) const {
  std::uint64_t sensed = 0;
  for (std::size_t i = 0; i < senses_.size(); ++i) {
    const SenseParameters& sense = senses_[i].parameters;
    const auto counts = [&](const CellContext& other) {
      return sense.of.empty() || (states_[other.state].counted >> i & 1);
    };
    const bool before = states_[cell.state].sensed >> i & 1;
    sensed |= std::uint64_t{isSensed(sense, cell, counts, before)} << i;
  }
  return sensed;
}

Substances LogicalDna::withoutSensed(const Substances& substances) const {
  Substances rest = substances;
  for (const Sense& sense : senses_) std::erase(rest, sense.substance);
  return rest;
}

StateId LogicalDna::nextOnSensing(StateId state, std::uint64_t sensed) const {
  for (const auto& [then, next] : states_[state].nextOnSensing)
    if (then == sensed) return next;
  const auto insertSensed = [&](Substances& substances) {
    for (std::size_t i = 0; i < senses_.size(); ++i)
      if (sensed >> i & 1) substances.push_back(senses_[i].substance);
    std::ranges::sort(substances);
    substances.erase(std::unique(substances.begin(), substances.end()), substances.end());
  };
  Substances present = withoutSensed(states_[state].substances);
  insertSensed(present);
  Substances products = runGenes(present);
  insertSensed(products);
  const StateId next = intern(std::move(products));  // may move states_
  states_[state].nextOnSensing.emplace_back(sensed, next);
  return next;
}

/// Returns true if the cell's cycle would divide it and the cell is too small for that. A cell without a body never
/// waits.
bool LogicalDna::waitsForSize(const CellContext& cell) const {
  if (!cell.physical()) return false;
  const State& next = states_[nextState(cell)];
  if (!next.divides || next.dies) return false;
  const double begin = divisionSize_->rule == DivisionSize::Rule::adder ? cell.sizeAtBirth() : 0;
  return cell.size() - begin < divisionSize_->size;
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

void LogicalDna::setGene(const std::string& name, bool on) {
  bool isKnown = false;
  for (std::vector<WaitingGene>& genes : waiting_)
    for (WaitingGene& gene : genes)
      if (gene.name == name) gene.isOn = on, isKnown = true;
  if (!isKnown) throw InputError("the DNA has no gene '" + name + "'");
  // Values kept with states follow from the genes, as cycle lengths of newborns do.
  for (State& state : states_) state.next = unknown, state.nextOnSensing.clear();
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const Substances substances = states_[i].substances;
    const auto has = [&](SubstanceId s) { return std::ranges::binary_search(substances, s); };
    states_[i].cycleLength = cycleLengthOf(substances, has(a_) || has(b_));
  }
}

}  // namespace

std::unique_ptr<BiologicalUnit> makeLogicalDna(const Dna& dna, const CycleParameters& cycle,
                                               std::span<const SenseParameters> senses) {
  return std::make_unique<LogicalDna>(dna, cycle, senses);
}

}  // namespace morula
