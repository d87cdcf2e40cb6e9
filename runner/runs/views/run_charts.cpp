#include "views/run_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/error.h"
#include "document/words.h"
#include "drawing/palette.h"
#include "store/sample_values.h"
#include "views/measure_bounds.h"

namespace morula {
namespace {

constexpr std::size_t maxLineLabels = 24;  // at the ends of lines

std::string nameOrPath(const CellPath& path, const Scenario& scenario) {
  return scenario.names.of(path).value_or(path.isEgg() ? "egg" : path.text());
}

[[noreturn]] void failWithout(const AskedMeasure& measure, const Scenario& scenario) {
  if (const auto unknown = unknownSubstance(measure, scenario.scene.dna.substances); !unknown.empty())
    throw InputError(measure.name + ": " + unknown);
  throw InputError("no sample of " + scenario.scene.name + " has " + measure.name +
                   (!measure.onDemand ? "; the scene has no parts that this measure needs"
                                      : "; name it in record.measures, as morula run --set 'record.measures=[" +
                                            measure.name + "]'"));
}

std::string wordsOf(const MeasuredThing& key, const AskedMeasure& measure, const Scenario& scenario) {
  if (measure.scope == Scope::world) return measure.name;
  const std::string a = nameOrPath(key.a, scenario);
  return measure.scope == Scope::cell ? a : a + "–" + nameOrPath(key.b, scenario);
}

const int founders = Colouring{}.founders;

}  // namespace

Chart seriesOf(const RunResults& results, const AskedMeasure& measure, const Scenario& scenario) {
  const ShownUnit unit = shownUnit(scenario.units, measure.unit), time = shownUnit(scenario.units, "time");
  const std::string title = unit.after(measure.title());
  std::map<MeasuredThing, std::vector<Spot>> series;
  for (const Sample& sample : results.samples)
    for (const auto& [key, value] : valuesIn(sample, measure, results.stateTexts))
      series[key].push_back({time.factor * sample.world.time, unit.factor * value});
  if (series.empty()) failWithout(measure, scenario);
  const double end = time.factor * results.samples.back().world.time;
  std::size_t atEnd = 0;
  for (const auto& [key, points] : series) atEnd += points.back().x == end;
  std::set<std::string> clones;
  const bool few = series.size() <= fewSeries;
  std::size_t number = 0;
  Chart chart;
  chart.title = scenario.scene.name;
  chart.caption =
      fmt::format("{} {} over time, {}", name(measure.scope), title, counted(results.samples.size(), "sample"));
  if (const std::string meaning = shortMeaningOf(measure); !meaning.empty()) chart.caption += ". " + meaning;
  chart.yBounds = boundsOf(measure, unit.factor);
  chart.xLabel = timeLabel(scenario.units), chart.yLabel = title;
  chart.xScale = chart.yScale = Axis::Scale::linear;
  chart.dots = few && results.samples.size() <= 40;
  for (auto& [key, points] : series) {
    const std::string founder = founderOf(key.a.text(), founders);
    clones.insert(founder);
    const bool labelled = series.size() == 1 ? false : few || (points.back().x == end && atEnd <= maxLineLabels);
    // A line that ends early has its label at its end; the others have theirs beside the chart.
    std::vector<std::string> atPoints;
    if (labelled && points.back().x < end) {
      atPoints.resize(points.size());
      atPoints.back() = wordsOf(key, measure, scenario);
    }
    chart.lines.push_back({labelled && atPoints.empty() ? wordsOf(key, measure, scenario) : "",
                           few ? seriesColour(number) : cloneColour(founder), std::move(points), false,
                           std::move(atPoints)});
    ++number;
  }
  if (!few) chart.legend = cloneLegend(clones, scenario);
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
    if (const auto area = pair["area"]) picture.values[a * n + b] = picture.values[b * n + a] = unit.factor * *area;
  }
  picture.title = scenario.scene.name;
  picture.caption = fmt::format("contact areas at time {}: {} cells, {} contacts",
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
      "directions of division axes, towards daughter A: {} divisions; the area of a sector is its number of "
      "divisions, and the outer circle is the largest sector",
      results.divisions.size());
  picture.roses = {{"from the front", "x", "z", {}}, {"from the right", "y", "z", {}}, {"from above", "x", "y", {}}};
  for (const DivisionRecord& division : results.divisions) {
    const Vector& a = division.axis;
    const std::pair<double, double> seen[] = {{a.x, a.z}, {a.y, a.z}, {a.x, a.y}};
    for (std::size_t i = 0; i < 3; ++i)  // an axis along the line of sight has no direction
      if (std::hypot(seen[i].first, seen[i].second) > 0.1)
        picture.roses[i].degrees.push_back(std::atan2(seen[i].second, seen[i].first) * 180 / std::numbers::pi);
  }
  return picture;
}

void colourTree(TreePicture& tree, const RunResults& results, const Colouring& colouring, const Scenario& scenario) {
  using By = Colouring::By;
  if (colouring.by == By::substance) return;
  tree.legend.clear();
  if (colouring.by == By::clone) {
    std::set<std::string> clones;
    for (LineageNode& node : tree.nodes) {
      const std::string founder = founderOf(node.path, colouring.founders);
      node.colour = cloneColour(founder);
      clones.insert(founder);
    }
    tree.legend = cloneLegend(clones, scenario);
    return;
  }
  struct Mean {
    double sum = 0;
    std::size_t count = 0;
    double value() const { return sum / double(count); }
  };
  std::map<std::string, Mean> means;
  const AskedMeasure measure =
      colouring.by == By::measure ? *findMeasure(colouring.measure) : readMeasure("cell.generation");
  if (colouring.by == By::generation)
    for (const LineageNode& node : tree.nodes) means[node.path] = {double(node.path.size()), 1};
  else
    for (const Sample& sample : results.samples)
      for (const auto& [key, value] : valuesIn(sample, measure, results.stateTexts)) {
        Mean& mean = means[key.a.text()];
        mean.sum += value, ++mean.count;
      }
  if (means.empty()) failWithout(measure, scenario);
  Range range;
  for (const auto& [path, mean] : means) range.see(mean.value());
  range = withoutRounding(range);
  bool lacks = false;
  for (LineageNode& node : tree.nodes) {
    const auto mean = means.find(node.path);
    lacks = lacks || mean == means.end();
    node.colour = mean == means.end() ? neutralGrey : scaleColour(range.shareOf(mean->second.value()));
  }
  if (lacks) tree.legend.push_back({neutralGrey, "in no sample"});
  const ShownUnit unit = shownUnit(scenario.units, measure.unit);
  const std::string of = colouring.by == By::measure ? ", mean over a cell's samples" : "";
  tree.colourBar = ColourBar{unit.after(measure.title()) + of, unit.factor * range.low, unit.factor * range.high};
}

}  // namespace morula
