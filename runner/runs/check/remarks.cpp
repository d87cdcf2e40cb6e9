#include "check/remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/number_text.h"
#include "division/rules.h"
#include "document/words.h"
#include "files/text.h"
#include "observation/observation.h"
#include "observation/organism_measures.h"

namespace morula {

std::string unsettledText(const PhysicsParameters& asked, const std::vector<SettlingRecord>& settlings) {
  const auto& residual = asked.quasiStatic.residual;
  if (!residual || settlings.empty() || settlings.back().residual <= *residual) return "";
  return fmt::format(
      "physics.quasi-static: the end has a residual of {:.3g} after {} evaluations, above the {:.3g} asked for; give a "
      "larger physics.quasi-static.residual, or more physics.quasi-static.evaluations",
      settlings.back().residual, settlings.back().evaluations, *residual);
}

std::string settledText(const PhysicsParameters& physics, const std::vector<SettlingRecord>& settlings) {
  if (physics.integrator != Integrator::quasiStatic || settlings.empty()) return "";
  std::uint64_t evaluations = 0;
  for (const SettlingRecord& s : settlings) evaluations += s.evaluations;
  const SettlingRecord& last = settlings.back();
  return fmt::format("{} in {}; left at the end: a residual of {:.2g}, an energy of motion of {:.2g}",
                     counted(evaluations, "evaluation"), counted(settlings.size(), "settling"), last.residual,
                     last.energyLeft.value_or(0));
}

std::vector<std::string> experimentLines(const Scenario& scenario, const std::vector<ExperimentRecord>& done) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < scenario.scene.experiments.size(); ++i) {
    const Experiment& e = scenario.scene.experiments[i];
    std::vector<std::string> cells;
    const ExperimentRecord* first = nullptr;
    for (const ExperimentRecord& record : done) {
      if (record.number != i + 1) continue;
      if (!first) first = &record;
      const bool isPair = record.to == DoneTo::pair;
      if (isPair || record.to == DoneTo::cell)
        cells.push_back(cellName(record.path.text()) + (isPair ? " and " + cellName(record.other.text()) : ""));
    }
    std::string line = std::string(nameOf(e.deed)) + (e.name.empty() ? "" : " " + e.name) +
                       (e.deed == Deed::set ? " to " + numberText(e.value) : "");
    constexpr std::size_t maxNamed = 4;
    if (!first) line += ": not done";
    else {
      line += " at time " + shownTime(scenario.units, first->time);
      if (cells.size() > maxNamed) line += ": " + counted(cells.size(), "cell");
      else if (!cells.empty()) line += ": " + join(cells);
      else if (first->to == DoneTo::nobody) line += ": no cell was chosen";
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string distanceText(const std::vector<SettlingRecord>& settlings) {
  const auto way = [](const SettlingRecord& s) { return s.displacementLeft.value_or(-1); };
  const auto count = std::ranges::count_if(settlings, [&](const SettlingRecord& s) { return way(s) >= 0; });
  if (count == 0) return "";
  const SettlingRecord& farthest = *std::ranges::max_element(settlings, {}, way);
  return fmt::format(
      "{} measured: while the residual falls to a hundredth of the tolerance, vertices move at most {:.2g}, at time "
      "{:.4g} with {}, and lose an energy of {:.2g}",
      counted(count, "settling") + (count == 1 ? " was" : " were"), *farthest.displacementLeft, farthest.time,
      counted(farthest.cells, "cell"), farthest.energyLeft.value_or(0));
}

bool isOtherScale(double scale) {
  constexpr double farFromOne = 2;  // another unit; embryos and scenes of one unit differ by less
  return scale > 0 && (scale > farFromOne || scale < 1 / farFromOne);
}

bool fitsMirrored(std::size_t cells, double shape, double mirrored) {
  // Fewer cells are nearly their own mirror images. An image that fits twice as well is no chance, unless both fit to 2 %.
  constexpr std::size_t fewest = 5;
  constexpr double clearlyLess = 0.5, clearly = 0.02;
  return cells >= fewest && shape > clearly && mirrored < clearlyLess * shape;
}

std::string positionsText(const World& world, const Scenario& scenario) {
  const auto& reference = scenario.check.reference;
  if (!reference || !world.bodies || std::ranges::none_of(scenario.record.measures, [](const std::string& name) {
        return name.starts_with("position_");
      }))
    return "";
  Observation now(world);
  now.reference = &*reference;
  const auto compared = comparePositions(now), mirrored = compareMirroredPositions(now);
  if (!compared || !mirrored) return "";
  std::vector<std::string> sentences;
  const double scale = compared->scale;
  const bool comparesLengths =
      std::ranges::find(scenario.record.measures, "position_rmsd") != scenario.record.measures.end();
  if (comparesLengths && isOtherScale(scale))
    sentences.push_back(fmt::format(
        "check.reference.positions lie {:.3g} times as far apart as the cells, and position_rmsd compares lengths "
        "without scaling; give the positions in the scene's unit of length, or compare by position_shape_rmsd",
        scale));
  if (fitsMirrored(compared->cells, compared->shape, mirrored->shape))
    sentences.push_back(fmt::format(
        "the mirror image of the cells fits check.reference.positions better than the cells do (position_shape_rmsd "
        "{:.2g} instead of {:.2g}); check the handedness of the reference's axes",
        mirrored->shape, compared->shape));
  return join(sentences, "; ");
}

std::vector<DivisionRecord> ambiguousDivisions(const Scene& scene, const std::vector<LineageEntry>& lineage,
                                               const std::function<std::string(StateId)>& describe,
                                               const std::vector<DivisionRecord>& divisions) {
  std::vector<DivisionRecord> ambiguous;
  if (!scene.mechanics) return ambiguous;
  std::map<CellPath, StateId> states;  // of mothers, as they were when they divided
  for (const LineageEntry& cell : lineage) states.emplace(cell.path, cell.state);
  for (const DivisionRecord& d : divisions) {
    if (!d.extentRatio || !(*d.extentRatio < ambiguousExtentRatio)) continue;
    const auto mother = states.find(d.path);
    const std::string substances = mother == states.end() ? "" : describe(mother->second);
    if (planeFor(scene.mechanics->division, d.path, substances).plane == DivisionPlane::longest) ambiguous.push_back(d);
  }
  return ambiguous;
}

}  // namespace morula
