#include "pictures/cell_colours.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "drawing/palette.h"
#include "simulation/measures.h"

namespace morula {

namespace {

constexpr Colour notMeasured = neutralGrey;

const CellMeasure* cellMeasure(std::string_view name) {
  for (const CellMeasure& row : measures<CellContext>())
    if (name == row.name) return &row;
  return nullptr;
}

bool isDrawn(const CellShape& cell) { return cell.opacity > 0; }

/// The ancestor that the clone is called by; a cell above it stands for itself.
std::string founderOf(const std::string& path, int founders) {
  return path.substr(0, std::min(path.size(), std::size_t(founders)));
}

std::string founderWords(const std::string& path, const Scenario& scenario) {
  const auto name = scenario.names.of(CellPath::parse(path));
  const std::string plain = path.empty() ? "egg" : path;
  return name && *name != plain ? *name + " (" + plain + ")" : plain;
}

void colourByClone(std::vector<OrganismPicture>& pictures,
                   const std::vector<std::vector<std::optional<double>>>& values, int founders,
                   const Scenario& scenario) {
  std::map<std::string, Colour> colours;
  const auto each = [&](auto act) {
    for (std::size_t p = 0; p < pictures.size(); ++p)
      for (std::size_t i = 0; i < values[p].size(); ++i)
        if (isDrawn(pictures[p].cells[i]))
          act(pictures[p].cells[i], founderOf(pictures[p].cells[i].path, founders));
  };
  each([&](const CellShape&, const std::string& founder) { colours.emplace(founder, Colour{}); });
  std::size_t number = 0;
  for (auto& [founder, colour] : colours) colour = seriesColour(number++);
  each([&](CellShape& cell, const std::string& founder) { cell.colour = colours.at(founder); });
  for (OrganismPicture& picture : pictures)
    for (const auto& [founder, colour] : colours)
      picture.legend.push_back({colour, founderWords(founder, scenario)});
}

void colourByGeneration(std::vector<OrganismPicture>& pictures,
                        const std::vector<std::vector<std::optional<double>>>& values) {
  std::set<int> generations;
  for (std::size_t p = 0; p < pictures.size(); ++p)
    for (std::size_t i = 0; i < values[p].size(); ++i)
      if (isDrawn(pictures[p].cells[i])) generations.insert(int(*values[p][i]));
  if (generations.empty()) return;
  const int first = *generations.begin(), last = *generations.rbegin();
  const auto colourOf = [&](int generation) {
    return last > first ? scaleColour(double(generation - first) / (last - first)) : scaleColour(0.5);
  };
  for (std::size_t p = 0; p < pictures.size(); ++p) {
    for (std::size_t i = 0; i < values[p].size(); ++i)
      pictures[p].cells[i].colour = colourOf(int(*values[p][i]));
    for (const int generation : generations)
      pictures[p].legend.push_back({colourOf(generation), "generation " + std::to_string(generation)});
  }
}

void colourByMeasure(std::vector<OrganismPicture>& pictures,
                     const std::vector<std::vector<std::optional<double>>>& values,
                     const CellMeasure& measure, const Units& units) {
  Range range;
  bool lacks = false;
  for (std::size_t p = 0; p < pictures.size(); ++p)
    for (std::size_t i = 0; i < values[p].size(); ++i)
      if (!isDrawn(pictures[p].cells[i])) continue;
      else if (const auto& value = values[p][i]) range.see(*value);
      else lacks = true;
  range = withoutRounding(range);
  const ShownUnit unit = shownUnit(units, measure.unit);
  std::string title = measure.name;
  std::replace(title.begin(), title.end(), '_', ' ');
  for (std::size_t p = 0; p < pictures.size(); ++p) {
    for (std::size_t i = 0; i < values[p].size(); ++i) {
      const double share =
          values[p][i] && range.low < range.high ? (*values[p][i] - range.low) / (range.high - range.low) : 0;
      pictures[p].cells[i].colour = values[p][i] ? scaleColour(share) : notMeasured;
    }
    if (range.low <= range.high)
      pictures[p].instruments.colourBar = {unit.after(title), unit.factor * range.low,
                                           unit.factor * range.high};
    if (lacks) pictures[p].legend.push_back({notMeasured, title + " not measured"});
  }
}

}  // namespace

Range withoutRounding(Range range) {
  constexpr double rounding = 1e-9;  // far more than sums of some thousand terms are off by
  const double most = std::max(std::abs(range.low), std::abs(range.high));
  if (range.low < range.high && range.high - range.low <= rounding * most) range.high = range.low;
  return range;
}

Colouring parseColouring(std::string_view text) {
  using By = Colouring::By;
  if (text == "substance") return {};
  if (text == "clone") return {.by = By::clone, .measure = {}};
  if (text == "generation") return {.by = By::generation, .measure = {}};
  if (text.starts_with("clone:") && text.size() == 7 && text[6] >= '1' && text[6] <= '4')
    return {.by = By::clone, .founders = text[6] - '0', .measure = {}};
  if (cellMeasure(text)) return {.by = By::measure, .measure = std::string(text)};
  std::vector<std::string> known{"substance", "clone", "generation"};
  for (const CellMeasure& row : measures<CellContext>()) known.push_back(row.name);
  const std::string near = closest(text, known);
  throw InputError("'" + std::string(text) +
                   "' is nothing to colour cells by; needs substance, clone, clone:1 to " +
                   "clone:4, generation, or a measure of cells (scenarios/MEASURES.md)" +
                   (near.empty() ? "" : "; did you mean " + near + "?"));
}

std::vector<std::optional<double>> colourValues(const World& world, const Colouring& colouring,
                                                const Scenario& scenario) {
  std::vector<std::optional<double>> values(world.cells.path.size());
  if (colouring.by == Colouring::By::generation)
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = double(world.cells.path[i].depth());
  if (colouring.by != Colouring::By::measure) return values;
  Observation now(world);
  if (scenario.check.reference) now.reference = &*scenario.check.reference;
  const CellMeasure& row = *cellMeasure(colouring.measure);
  if (row.needs == Needs::bodies && !world.bodies) return values;
  if (row.taken == Taken::withSamples) {
    const auto cells = measureCells(now);
    for (std::size_t i = 0; i < cells.size(); ++i) values[i] = cells[i][colouring.measure];
    return values;
  }
  const std::vector<std::string> names{colouring.measure};
  for (const TakenMeasure& taken : takeMeasures(now, names))
    if (const int number = cellNumber(world.cells, taken.a); taken.scope == Scope::cell && number >= 0)
      values[std::size_t(number)] = taken.value;
  return values;
}

void colourCells(std::vector<OrganismPicture>& pictures,
                 const std::vector<std::vector<std::optional<double>>>& values, const Colouring& colouring,
                 const Scenario& scenario) {
  if (colouring.by == Colouring::By::substance) return;
  for (OrganismPicture& picture : pictures) picture.legend.clear();
  if (colouring.by == Colouring::By::clone) colourByClone(pictures, values, colouring.founders, scenario);
  if (colouring.by == Colouring::By::generation) colourByGeneration(pictures, values);
  if (colouring.by == Colouring::By::measure)
    colourByMeasure(pictures, values, *cellMeasure(colouring.measure), scenario.units);
}

}  // namespace morula
