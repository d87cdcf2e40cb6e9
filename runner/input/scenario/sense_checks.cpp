// Checks senses and the size at division against the scene and its genes.
#include <algorithm>

#include "base/did_you_mean.h"
#include "biology/sense.h"
#include "biology/substances.h"
#include "physics/cell_model.h"
#include "scenario/scene_checks.h"
#include "yaml/numbers.h"

namespace morula::scenario {
namespace {

bool isRead(const Dna& dna, const std::string& name) {
  const auto id = findSubstance(dna, name);
  return id && std::ranges::any_of(dna.genes, [&](const Gene& gene) {
           return std::ranges::binary_search(gene.inputs, *id) || std::ranges::binary_search(gene.repressors, *id);
         });
}

struct Lack {
  std::string wrong, right;  // both empty: nothing is lacking
};

Lack findLack(SenseNeeds needs, const Scene& scene) {
  if (needs == SenseNeeds::nothing) return {};
  if (!scene.mechanics)
    return {"needs bodies, and without physics cells have none", "add a physics block, or remove this"};
  const MechanicsScene& m = *scene.mechanics;
  const CellModelKind& model = kindOf(m.physics.cell.model);
  const std::string remove = ", or remove this", name = nameOf(m.physics.cell.model);
  switch (needs) {
    case SenseNeeds::membrane:
      if (!model.hasMembrane)
        return {"cells of model " + name + " have no contents under pressure",
                "needs physics.cell.model shell" + remove};
      break;
    case SenseNeeds::shell:
      if (!m.physics.shell) return {"the scene has no shell to touch", "add a physics.shell" + remove};
      [[fallthrough]];
    case SenseNeeds::mesh:
      if (!model.hasMesh) return {"a ball has no surface of its own", "needs another physics.cell.model" + remove};
      break;
    case SenseNeeds::contact:
      if (!m.contact) return {"cells do not touch without physics.contact", "add 'contact: {}' to physics" + remove};
      break;
    case SenseNeeds::connections:
      if (!m.connections)
        return {"cells do not connect without a section connections", "add 'connections: {}'" + remove};
      break;
    case SenseNeeds::nothing:
    case SenseNeeds::bodies: break;
  }
  return {};
}

bool canHold(const Scenario& scenario, const std::string& name) {
  const Dna& dna = scenario.scene.dna;
  const auto id = findSubstance(dna, name);
  if (id && (std::ranges::find(dna.start, *id) != dna.start.end() ||
             std::ranges::find(dna.genes, *id, &Gene::product) != dna.genes.end()))
    return true;
  return std::ranges::any_of(scenario.scene.cells, [&](const StartCell& cell) {
    return cell.substances && std::ranges::find(*cell.substances, name) != cell.substances->end();
  });
}

}  // namespace

void checkSenses(const SceneCheck& check) {
  const Dna& dna = check.scene().dna;
  const auto& senses = check.scene().senses;
  for (const SenseParameters& sense : senses) {
    const SenseKindRow& row = kindOf(sense.kind);
    const std::string path = "senses." + sense.substance;
    const auto [wrong, right] = findLack(row.needs, check.scene());
    if (!wrong.empty()) check.refuse(path + "." + row.name, wrong, right);
    if (dna.substances.empty() || isRead(dna, sense.substance)) continue;  // empty: an unreadable DNA
    check.refuse(path, "no gene reads '" + sense.substance + "'",
                 "write a gene that reads it, as g9(a1|a0, " + sense.substance + "), or remove this");
  }
  for (const SubstanceUse& use : check.reading.substances)
    if (use.path.starts_with("cells") &&
        std::ranges::find(senses, use.name, &SenseParameters::substance) != senses.end())
      check.reading.problems.add(use.place, use.path, "'" + use.name + "' is a sense, which the simulator inserts",
                                 "remove it, or take another name");
}

void checkDivisionSize(const SceneCheck& check) {
  if (check.scene().cycle.divisionSize && !check.physics().growth)
    check.refuse("division.size", "without physics.growth no cell grows to any size",
                 "add 'growth: {}' to physics, or remove this");
}

void checkFirstCycle(const SceneCheck& check) {
  if (check.scene().cycle.first == FirstCycle::atBirth && !check.scene().cycle.atBirth.empty())
    check.refuse("cycle.at-birth", "cells whose genes are read at birth have no first cycle to wait for",
                 "give these lengths under per-substance, or remove first");
}

std::vector<std::string> sizeWarnings(const Scenario& scenario, const Node& root) {
  const auto& size = scenario.scene.cycle.divisionSize;
  if (!size) return {};
  std::vector<std::string> warnings;
  const auto warn = [&](const std::string& text) {
    warnings.push_back(placeText(scenario.file, placeOf(root, "division.size")) + ": division.size: " + text);
  };
  double largest = scenario.scene.cells.empty() ? 1 : 0;
  for (const StartCell& cell : scenario.scene.cells) largest = std::max(largest, cell.scale * cell.scale * cell.scale);
  const double most = std::max(largest, scenario.scene.mechanics->physics.growth->until.value_or(INFINITY));
  if (!canHold(scenario, substance::grow))
    warn("no gene produces 'grow', so no cell reaches the size for its division; write a gene such as g9(grow|a0)");
  else if (size->size > most)
    warn("cells stop growing at size " + exactText(most) + ", so no cell reaches the size for its division, " +
         exactText(size->size) + "; raise physics.growth.until");
  return warnings;
}

}  // namespace morula::scenario
