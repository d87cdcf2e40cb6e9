#include "views/cell_colours.h"

#include <algorithm>
#include <cmath>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "drawing/palette.h"
#include "observation/asked_measure.h"
#include "pictures/pictures.h"
#include "store/sample_values.h"
#include "values/cell_words.h"

namespace morula {
namespace {

constexpr Colour notMeasured = neutralGrey;

AskedMeasure cellMeasure(std::string_view text) {
  const auto dot = text.find('.');
  return readMeasure((dot == text.npos ? "cell." : "") + std::string(text));
}

bool isDrawn(const CellShape& cell) { return cell.opacity > 0; }

std::string founderWords(const std::string& path, const Scenario& scenario) {
  const auto name = scenario.names.of(CellPath::parse(path));
  const std::string plain = path.empty() ? "egg" : path;
  return name && *name != plain ? *name + " (" + plain + ")" : plain;
}

void colourByClone(std::vector<OrganismPicture>& pictures,
                   const std::vector<std::vector<std::optional<double>>>& values, int founders,
                   const Scenario& scenario) {
  for (std::size_t p = 0; p < pictures.size(); ++p) {
    std::set<std::string> seen;
    for (std::size_t i = 0; i < values[p].size(); ++i) {
      CellShape& cell = pictures[p].cells[i];
      const std::string founder = founderOf(cell.path, founders);
      cell.colour = cloneColour(founder);
      if (isDrawn(cell)) seen.insert(founder);
    }
    pictures[p].legend = cloneLegend(seen, scenario);
  }
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
    std::set<int> own;
    for (std::size_t i = 0; i < values[p].size(); ++i) {
      CellShape& cell = pictures[p].cells[i];
      cell.colour = colourOf(int(*values[p][i]));
      if (isDrawn(cell)) own.insert(int(*values[p][i]));
    }
    for (const int generation : own)
      pictures[p].legend.push_back({colourOf(generation), "generation " + std::to_string(generation)});
  }
}

void colourByMeasure(std::vector<OrganismPicture>& pictures,
                     const std::vector<std::vector<std::optional<double>>>& values, const AskedMeasure& measure,
                     const Units& units) {
  Range range;
  bool lacks = false;
  for (std::size_t p = 0; p < pictures.size(); ++p)
    for (std::size_t i = 0; i < values[p].size(); ++i)
      if (!isDrawn(pictures[p].cells[i])) continue;
      else if (const auto& value = values[p][i]) range.see(*value);
      else lacks = true;
  range = withoutRounding(range);
  const ShownUnit unit = shownUnit(units, measure.unit);
  for (std::size_t p = 0; p < pictures.size(); ++p) {
    for (std::size_t i = 0; i < values[p].size(); ++i)
      pictures[p].cells[i].colour = values[p][i] ? scaleColour(range.shareOf(*values[p][i])) : notMeasured;
    if (range.low <= range.high)
      pictures[p].instruments.colourBar = {unit.after(measure.title()), unit.factor * range.low,
                                           unit.factor * range.high};
    if (lacks) pictures[p].legend.push_back({notMeasured, measure.title() + " not measured"});
  }
}

}  // namespace

Range withoutRounding(Range range) {
  constexpr double rounding = 1e-9;  // far above the rounding error of a sum of some thousand terms
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
  std::string wrong = "'" + std::string(text) + "' is no colouring of cells";
  try {
    if (AskedMeasure m = cellMeasure(text); m.scope == Scope::cell) return {.by = By::measure, .measure = m.name};
  } catch (const InputError& error) {
    if (text.find(' ') != text.npos) wrong = error.what();
  }
  std::vector<std::string> known{"substance", "clone", "generation"};
  for (const CellMeasure& row : measures<CellContext>()) known.push_back(row.name);
  const std::string near = closest(text.starts_with("cell.") ? text.substr(5) : text, known);
  throw InputError(wrong + "; needs substance, clone, clone:1 to clone:4, generation, or a measure of cells " +
                   "(scenarios/MEASURES.md)" + (near.empty() ? "" : "; did you mean " + near + "?"));
}

std::string founderOf(const std::string& path, int founders) {
  return path.substr(0, std::min(path.size(), std::size_t(founders)));
}

std::vector<LegendEntry> cloneLegend(const std::set<std::string>& founders, const Scenario& scenario) {
  std::vector<LegendEntry> legend;
  for (const std::string& founder : founders) {
    const Colour colour = cloneColour(founder);
    const auto same = std::ranges::find(legend, colour, &LegendEntry::colour);
    if (same == legend.end()) legend.push_back({colour, founderWords(founder, scenario)});
    else same->label += ", " + founderWords(founder, scenario);
  }
  return legend;
}

std::vector<std::optional<double>> colourValues(const World& world, const Colouring& colouring,
                                                const Scenario& scenario) {
  std::vector<std::optional<double>> values(world.cells.path.size());
  if (colouring.by == Colouring::By::generation)
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = double(world.cells.path[i].depth());
  if (colouring.by != Colouring::By::measure) return values;
  Observation now(world);
  if (scenario.check.reference) now.reference = &*scenario.check.reference;
  const AskedMeasure asked = resolved(*findMeasure(colouring.measure), scenario.names, scenario.scene.dna);
  if (asked.needs == Needs::bodies && !world.bodies) return values;
  Sample sample;
  std::map<StateId, std::string> states;
  sample.cells = measureCells(now);
  for (const CellMeasures& c : sample.cells) states.emplace(c.state, world.biology->describe(c.state));
  if (asked.onDemand) sample.more = takeMeasures(now, std::vector{asked.name});
  for (const auto& [cell, value] : valuesIn(sample, asked, states))
    values[std::size_t(cellNumber(world.cells, cell.a))] = value;
  return values;
}

void colourCells(std::vector<OrganismPicture>& pictures, const std::vector<std::vector<std::optional<double>>>& values,
                 const Colouring& colouring, const Scenario& scenario) {
  if (colouring.by == Colouring::By::substance) return shareLegend(pictures);
  for (OrganismPicture& picture : pictures) picture.legend.clear();
  if (colouring.by == Colouring::By::clone) colourByClone(pictures, values, colouring.founders, scenario);
  if (colouring.by == Colouring::By::generation) colourByGeneration(pictures, values);
  if (colouring.by == Colouring::By::measure)
    colourByMeasure(pictures, values, *findMeasure(colouring.measure), scenario.units);
  else shareLegend(pictures);
}

}  // namespace morula
