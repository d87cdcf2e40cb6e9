#include "pictures/run_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "document/words.h"
#include "drawing/palette.h"
#include "pictures/cell_colours.h"

namespace morula {

namespace {

constexpr std::size_t mostLineLabels = 24;  // at the ends of lines

template <class Of>
void findMeasure(std::string_view name, Scope scope, std::optional<MeasureName>& found) {
  for (const Measure<Of>& row : measures<Of>()) {
    if (found || name != row.name) continue;
    std::string title = row.name;
    std::replace(title.begin(), title.end(), '_', ' ');
    found = MeasureName{scope, row.name, title, row.unit};
  }
}

template <class Of>
void addNames(std::vector<std::string>& names) {
  for (const Measure<Of>& row : measures<Of>()) names.push_back(row.name);
}

std::string nameOrPath(const CellPath& path, const Scenario& scenario) {
  return scenario.names.of(path).value_or(path.isEgg() ? "egg" : path.text());
}

bool isSampled(const MeasureName& measure) {
  const auto has = [&](const auto& rows) {
    return std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return measure.name == row.name; });
  };
  return measure.scope == Scope::world  ? has(sampledMeasures<Observation>())
         : measure.scope == Scope::cell ? has(sampledMeasures<CellContext>())
                                        : has(sampledMeasures<Touch>());
}

struct Key {
  CellPath a, b;
  auto operator<=>(const Key&) const = default;
};

/// The values of the measure in one sample; the world's under an empty key.
std::map<Key, double> valuesIn(const Sample& sample, const MeasureName& measure) {
  std::map<Key, double> values;
  const auto add = [&](const Key& key, const std::optional<double>& value) {
    if (value) values[key] = *value;
  };
  if (!isSampled(measure)) {
    for (const TakenMeasure& taken : sample.more)
      if (taken.scope == measure.scope && taken.name == measure.name) add({taken.a, taken.b}, taken.value);
  } else if (measure.scope == Scope::world) {
    add({}, sample.world[measure.name]);
  } else if (measure.scope == Scope::cell) {
    for (const CellMeasures& cell : sample.cells) add({cell.path, {}}, cell[measure.name]);
  } else {
    for (const ContactMeasures& pair : sample.contacts) add({pair.a, pair.b}, pair[measure.name]);
  }
  return values;
}

[[noreturn]] void failWithout(const MeasureName& measure, const Scenario& scenario) {
  throw InputError("no sample of " + scenario.scene.name + " has " + measure.name +
                   (isSampled(measure)
                        ? "; the scene has nothing that it could be measured of"
                        : "; record.measures must name it: --set record.measures=[" + measure.name + "]"));
}

std::string wordsOf(const Key& key, const MeasureName& measure, const Scenario& scenario) {
  if (measure.scope == Scope::world) return measure.name;
  const std::string a = nameOrPath(key.a, scenario);
  return measure.scope == Scope::cell ? a : a + "–" + nameOrPath(key.b, scenario);
}

/// The clone of a cell, by its founder two divisions below the egg.
CellPath founderOf(const CellPath& path) { return CellPath::parse(path.text().substr(0, 2)); }

}  // namespace

MeasureName parseMeasure(std::string_view text) {
  std::string_view name = text, scope;
  if (const auto dot = text.find('.'); dot != text.npos)
    scope = text.substr(0, dot), name = text.substr(dot + 1);
  std::optional<MeasureName> found;
  if (scope.empty() || scope == "world") findMeasure<Observation>(name, Scope::world, found);
  if (scope.empty() || scope == "cell") findMeasure<CellContext>(name, Scope::cell, found);
  if (scope.empty() || scope == "pair") findMeasure<Touch>(name, Scope::pair, found);
  if (found) return *found;
  std::vector<std::string> names;
  addNames<Observation>(names);
  addNames<CellContext>(names);
  addNames<Touch>(names);
  const std::string near = closest(name, names);
  throw InputError(
      "'" + std::string(text) +
      "' is no measure; needs one of scenarios/MEASURES.md, alone or with what it is of: cell.volume" +
      (near.empty() ? "" : "; did you mean " + near + "?"));
}

Chart seriesOf(const RunResults& results, const MeasureName& measure, const Scenario& scenario) {
  const ShownUnit unit = shownUnit(scenario.units, measure.unit), time = shownUnit(scenario.units, "time");
  const std::string title = unit.after(measure.title);
  std::map<Key, std::vector<Spot>> series;
  for (const Sample& sample : results.samples)
    for (const auto& [key, value] : valuesIn(sample, measure))
      series[key].push_back({time.factor * sample.world.time, unit.factor * value});
  if (series.empty()) failWithout(measure, scenario);
  const double end = time.factor * results.samples.back().world.time;
  std::size_t atEnd = 0;
  for (const auto& [key, points] : series) atEnd += points.back().x == end;
  std::map<CellPath, Colour> clones;
  const bool few = series.size() <= fewSeries;
  for (const auto& [key, points] : series) clones.emplace(founderOf(key.a), Colour{});
  std::size_t number = 0;
  for (auto& [founder, colour] : clones) colour = seriesColour(number++);
  Chart chart;
  chart.title = scenario.scene.name;
  chart.caption = fmt::format("{} {} over time, {}", name(measure.scope), title,
                              counted(results.samples.size(), "sample"));
  chart.xLabel = timeLabel(scenario.units), chart.yLabel = title;
  chart.xScale = chart.yScale = Axis::Scale::linear;
  chart.dots = few && results.samples.size() <= 40;
  number = 0;
  for (auto& [key, points] : series) {
    const bool labelled =
        series.size() == 1 ? false : few || (points.back().x == end && atEnd <= mostLineLabels);
    // What ends early has its label there, the others theirs beside the chart.
    std::vector<std::string> atPoints;
    if (labelled && points.back().x < end) {
      atPoints.resize(points.size());
      atPoints.back() = wordsOf(key, measure, scenario);
    }
    chart.lines.push_back({labelled && atPoints.empty() ? wordsOf(key, measure, scenario) : "",
                           few ? seriesColour(number) : clones.at(founderOf(key.a)), std::move(points), false,
                           std::move(atPoints)});
    ++number;
  }
  if (!few)
    for (const auto& [founder, colour] : clones)
      chart.legend.push_back(
          {colour, nameOrPath(founder, scenario) + (founder.depth() < 2 ? "" : " and its descendants")});
  return chart;
}

MatrixPicture contactsOf(const RunResults& results, double time, const Scenario& scenario) {
  const Sample* last = nullptr;
  for (const Sample& sample : results.samples)
    if (sample.world.time <= time * (1 + 1e-9)) last = &sample;
  if (!last || last->cells.empty())
    throw InputError("no sample of " + scenario.scene.name +
                     fmt::format(" up to time {:.6g} has cells with bodies", time));
  if (!scenario.scene.mechanics || !scenario.scene.mechanics->contact)
    throw InputError(scenario.scene.name + " has no physics.contact: cells in it do not touch");
  const ShownUnit unit = shownUnit(scenario.units, "length²");
  MatrixPicture picture;
  const std::size_t n = last->cells.size();
  picture.values.resize(n * n);
  std::map<CellPath, std::size_t> rows;
  for (const CellMeasures& cell : last->cells) {
    rows.emplace(cell.path, picture.names.size());
    picture.names.push_back(nameOrPath(cell.path, scenario));
  }
  for (const ContactMeasures& pair : last->contacts) {
    const std::size_t a = rows.at(pair.a), b = rows.at(pair.b);
    if (const auto area = pair["area"])
      picture.values[a * n + b] = picture.values[b * n + a] = unit.factor * *area;
  }
  picture.title = scenario.scene.name;
  picture.caption = fmt::format("who touches whom at time {}: {} cells, {} contacts",
                                shownTime(scenario.units, last->world.time, 6), n, last->contacts.size());
  picture.quantity = unit.after("contact area");
  return picture;
}

RosePicture divisionsOf(const RunResults& results, const Scenario& scenario) {
  if (results.divisions.empty())
    throw InputError(scenario.scene.name + " has no divisions of cells with bodies, so no axes to show");
  RosePicture picture;
  picture.title = scenario.scene.name;
  picture.caption = fmt::format(
      "which way division axes point, towards daughter A: {} divisions; a sector's area is its count, the "
      "outer circle the "
      "largest",
      results.divisions.size());
  picture.roses = {
      {"from the front", "x", "z", {}}, {"from the right", "y", "z", {}}, {"from above", "x", "y", {}}};
  for (const DivisionRecord& division : results.divisions) {
    const Vector& a = division.axis;
    const std::pair<double, double> seen[] = {{a.x, a.z}, {a.y, a.z}, {a.x, a.y}};
    for (std::size_t i = 0; i < 3; ++i)  // an axis along the line of sight has no direction
      if (std::hypot(seen[i].first, seen[i].second) > 0.1)
        picture.roses[i].degrees.push_back(std::atan2(seen[i].second, seen[i].first) * 180 /
                                           std::numbers::pi);
  }
  return picture;
}

void colourTree(TreePicture& tree, const RunResults& results, const MeasureName& measure,
                const Units& units) {
  if (measure.scope != Scope::cell)
    throw InputError(measure.name + " is a measure of the " + name(measure.scope) +
                     ", and a tree shows cells");
  struct Mean {
    double sum = 0;
    std::size_t count = 0;
  };
  std::map<std::string, Mean> means;
  for (const Sample& sample : results.samples)
    for (const auto& [key, value] : valuesIn(sample, measure)) {
      Mean& mean = means[key.a.text()];
      mean.sum += value, ++mean.count;
    }
  Range range;
  for (const auto& [path, mean] : means) range.see(mean.sum / double(mean.count));
  range = withoutRounding(range);
  bool lacks = false;
  tree.legend.clear();
  for (LineageNode& node : tree.nodes) {
    const auto mean = means.find(node.path);
    lacks = lacks || mean == means.end();
    node.colour = mean == means.end() ? neutralGrey
                  : range.low < range.high
                      ? scaleColour((mean->second.sum / double(mean->second.count) - range.low) /
                                    (range.high - range.low))
                      : scaleColour(0);
  }
  if (means.empty())
    throw InputError("no sample has " + measure.name +
                     (isSampled(measure) ? "" : "; record.measures must name it"));
  if (lacks) tree.legend.push_back({neutralGrey, "in no sample"});
  const ShownUnit unit = shownUnit(units, measure.unit);
  tree.colourBar = ColourBar{unit.after(measure.title) + ", mean over a cell's samples",
                             unit.factor * range.low, unit.factor * range.high};
}

}  // namespace morula
