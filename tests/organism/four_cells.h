#pragma once
// The arrangement of four cells: which of them touch.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "observation/measures.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"

namespace four_cells {

using namespace morula;

/// The arrangement of the grandchildren of an egg: AA, AB, BA, BB.
struct Arrangement {
  std::map<std::string, double> contact;   // [1] "AA-AB": the contact's area over the mean of all contacts
  std::map<std::string, double> distance;  // [length] between the centres
  std::string name;                        // tetrahedron, diamond, T, square, linear; "other"
};

/// Returns an arrangement's name by the graph of the contacts whose areas are above 5 % of the mean.
inline std::string nameOf(const std::map<std::string, double>& contact) {
  std::map<std::string, int> degree;
  int contacts = 0;
  for (const auto& [pair, area] : contact)
    if (area > 0.05) ++contacts, ++degree[pair.substr(0, 2)], ++degree[pair.substr(3)];
  int most = 0, cells = 0;
  for (const auto& [cell, touched] : degree) most = std::max(most, touched), ++cells;
  if (contacts == 6) return "tetrahedron";
  if (contacts == 5) return "diamond";
  if (contacts == 4 && cells == 4) return most == 3 ? "T" : "square";
  if (contacts == 3 && cells == 4 && most == 2) return "linear";
  return "other";
}

inline Arrangement arrangementOf(const World& world) {
  Arrangement found;
  const auto contacts = measureContacts(world);
  double sum = 0;
  for (const ContactMeasures& touch : contacts) sum += touch.at("area");
  for (const ContactMeasures& touch : contacts)
    found.contact[touch.a.text() + "-" + touch.b.text()] =
        touch.at("area") * static_cast<double>(contacts.size()) / sum;
  const auto cells = measureCells(world);
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t j = i + 1; j < cells.size(); ++j) {
      const Vector apart{cells[i].at("x") - cells[j].at("x"), cells[i].at("y") - cells[j].at("y"),
                         cells[i].at("z") - cells[j].at("z")};
      found.distance[cells[i].path.text() + "-" + cells[j].path.text()] = norm(apart);
    }
  found.name = nameOf(found.contact);
  return found;
}

/// Runs the scenario with these changes for each seed from 1 on.
inline std::vector<Arrangement> runSeeds(const std::string& file, int seeds, const std::vector<std::string>& changes) {
  std::vector<Override> overrides;
  for (const std::string& change : changes) overrides.push_back(parseOverride(change));
  const Scene scene = loadScenario(std::string(MORULA_SOURCE_DIR "/scenarios/") + file, overrides).scene;
  std::vector<Arrangement> all(seeds);
  parallelFor(seeds, 2, [&](int i) {
    Scene seeded = scene;
    seeded.seed = i + 1;
    World world = makeWorld(seeded);
    while (!finished(world)) step(world);
    all[i] = arrangementOf(world);
  });
  return all;
}

}  // namespace four_cells
