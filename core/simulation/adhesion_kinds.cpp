// The sets of cells that stick to others alike: by the adhesion pairs that their substances fit, and by their
// deviations.
#include "simulation/adhesion_kinds.h"

#include <map>

#include "base/random.h"
#include "biology/substance_pattern.h"
#include "contacts/contacts.h"

namespace morula {
namespace {

/// The ends of pairs that a cell fits: [2 · pair + end]. Cells of one kind fit the same ends.
using Ends = std::vector<bool>;

Ends endsOf(const AdhesionParameters& p, const std::string& substances) {
  Ends ends;
  for (const AdhesionPair& pair : p.pairs) {
    ends.push_back(fitsAny(pair.a, substances));
    ends.push_back(fitsAny(pair.b, substances));
  }
  return ends;
}

double workOf(const AdhesionParameters& p, const Ends& one, const Ends& other) {
  for (std::size_t i = 0; i < p.pairs.size(); ++i) {
    const std::size_t a = 2 * i, b = a + 1;
    if ((one[a] && other[b]) || (one[b] && other[a])) return p.pairs[i].strength;
  }
  return p.strength;
}

/// Returns the factor of each slot; empty where the seed varies none.
std::vector<double> ownFactors(const World& world) {
  const double sd = world.model.variation.adhesion;
  if (sd == 0) return {};
  std::vector<double> factors(world.bodies->restScale.size(), 1);
  for (std::size_t cell = 0; cell < world.cells.path.size(); ++cell)
    factors[world.bodies->slots[cell]] =
        1 + sd * randomDeviate({world.model.seed, world.cells.path[cell], 0, Purpose::adhesionVariation});
  return factors;
}

}  // namespace

void sortByAdhesion(World& world) {
  if (!world.contacts || !world.contacts->parameters.adhesion) return;
  const AdhesionParameters& p = *world.contacts->parameters.adhesion;
  if (p.pairs.empty() && world.model.variation.adhesion == 0) return;
  const Bodies& bodies = *world.bodies;
  AdhesionKinds kinds{std::vector<int>(bodies.restScale.size(), 0), 0, {}, ownFactors(world)};
  std::map<StateId, int> ofState;  // a state is described once
  std::map<Ends, int> ofEnds;
  std::vector<Ends> ends;  // [kind]
  for (std::size_t cell = 0; cell < world.cells.state.size(); ++cell) {
    const auto [state, isNew] = ofState.try_emplace(world.cells.state[cell], 0);
    if (isNew) {
      const Ends own = endsOf(p, world.biology->describe(state->first));
      const auto [kind, isNewKind] = ofEnds.try_emplace(own, static_cast<int>(ends.size()));
      if (isNewKind) ends.push_back(own);
      state->second = kind->second;
    }
    kinds.ofSlot[bodies.slots[cell]] = state->second;
  }
  kinds.count = static_cast<int>(ends.size());
  for (const Ends& one : ends)
    for (const Ends& other : ends) kinds.work.push_back(workOf(p, one, other));
  setAdhesionKinds(*world.contacts, std::move(kinds));
}

}  // namespace morula
