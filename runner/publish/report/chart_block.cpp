// Charts of runs: measures over time, contacts of cells, directions of divisions.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "analysis/measure_words.h"
#include "base/error.h"
#include "drawing/palette.h"
#include "files/printable.h"
#include "report/run_blocks.h"
#include "system/json.h"
#include "views/run_charts.h"

namespace morula {
namespace {

constexpr std::size_t maxLines = 24;     // max number of runs in one chart
constexpr std::size_t maxLabels = 10;    // max number of labels at the ends of lines
constexpr std::size_t maxCellLines = 400;  // max number of cells whose curves one chart has
constexpr std::size_t maxTouching = 60;  // max number of cells in a matrix of contacts
// [pixel] Small enough that words of ordinary size are legible with three charts side by side.
constexpr int width = 420, height = 300;

Chart timeChart(const std::string& title, const std::string& unit, const Units& units) {
  Chart chart;
  chart.title = title, chart.xLabel = timeLabel(units), chart.yLabel = unit;
  chart.xScale = chart.yScale = Axis::Scale::linear;
  chart.dots = false;
  chart.width = width, chart.height = height;
  return chart;
}

/// Returns a chart's lines for the page's program (reports/explorer/src/live_chart.ts); "" if they are too many.
std::string liveOf(const Chart& chart) {
  constexpr std::size_t most = 20'000;  // points
  std::string lines;
  std::size_t count = 0;
  for (const ChartLine& line : chart.lines) {
    std::string xs, ys;
    for (const Spot& point : line.points) {
      fmt::format_to(std::back_inserter(xs), "{}{:.6g}", xs.empty() ? "" : ",", point.x);
      fmt::format_to(std::back_inserter(ys), "{}{:.6g}", ys.empty() ? "" : ",", point.y);
    }
    count += line.points.size();
    lines += fmt::format("{}[{},\"#{:02x}{:02x}{:02x}\",{},[{}],[{}]]", lines.empty() ? "" : ",",
                         jsonText(printableLine(line.label)), line.colour.r, line.colour.g, line.colour.b, line.dashed,
                         xs, ys);
  }
  if (count > most) return {};
  return fmt::format("[{},{},[{}]]", jsonText(chart.xLabel), jsonText(chart.title), lines);
}

/// Gives a chart's picture an id, under which the page's program finds its lines.
Picture& enliven(Picture& picture, const std::string& lines, Json& live) {
  if (lines.empty()) return picture;
  picture.id = "chart-" + std::to_string(live.size());
  live[picture.id] = Json::parse(lines);
  return picture;
}

/// Returns the number of cells over time, as steps at divisions and deaths.
std::vector<Spot> cellsOverTime(const RunFacts& facts) {
  std::vector<std::pair<double, int>> changes;
  for (const LineageEntry& cell : facts.results.lineage) {
    changes.push_back({cell.born, 1});
    if (cell.fate != Fate::alive) changes.push_back({cell.ended, -1});
  }
  std::sort(changes.begin(), changes.end());
  std::vector<Spot> points;
  int alive = 0;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const int before = alive;
    const double time = changes[i].first;
    for (alive += changes[i].second; i + 1 < changes.size() && changes[i + 1].first == time; ++i)
      alive += changes[i + 1].second;
    if (!points.empty() && before != alive) points.push_back({time, double(before)});
    if (points.empty() || before != alive) points.push_back({time, double(alive)});
  }
  if (!points.empty()) points.push_back({facts.run.time, double(alive)});
  return points;
}

std::vector<Spot> measureOverTime(const RunFacts& facts, std::size_t measure) {
  std::vector<Spot> points;
  const auto add = [&](const WorldMeasures& world) {
    if (const auto& value = world.values[measure]; value && std::isfinite(*value))
      points.push_back({world.time, *value});
  };
  if (facts.again && facts.again->same)
    for (const WorldMeasures& world : facts.again->frames.worlds) add(world);
  else
    for (const Sample& sample : facts.results.samples) add(sample.world);
  return points;
}

/// Adds a line of values in `unit`, converted to the units of people.
void addLine(Chart& chart, std::size_t number, std::size_t count, std::vector<Spot> points, const Units& units,
             std::string_view unit = "") {
  if (points.size() < 2) return;
  const double perTime = shownUnit(units, "time").factor, perUnit = shownUnit(units, unit).factor;
  for (Spot& point : points) point.x *= perTime, point.y *= perUnit;
  const std::string label = count > 1 && count <= maxLabels ? std::to_string(number + 1) : "";
  // Lines differ without colours, too: by numbers at their ends, and every second line is dashed.
  chart.lines.push_back({label, seriesColour(number), std::move(points), number % 2 == 1, {}});
}

/// Makes the key of the runs' numbers and colours in the charts.
LineKey keyOf(const std::vector<RunFacts>& runs, std::size_t count) {
  LineKey key;
  for (std::size_t i = 0; i < count; ++i)
    key.lines.push_back(
        {seriesColour(i), i % 2 == 1, (count <= maxLabels ? std::to_string(i + 1) + " " : "") + titleOf(runs[i])});
  return key;
}

/// Returns the charted measures of cells, and those that the scenario asks for.
std::vector<std::string> moreMeasures(const RunFacts& run) {
  std::vector<std::string> names{"cell.volume", "cell.pressure"};
  std::set<std::string> known;
  for (const Sample& sample : run.results.samples)
    for (const TakenMeasure& taken : sample.more)
      if (known.insert(taken.name).second)
        names.push_back(taken.scope == Scope::world ? taken.name : std::string(name(taken.scope)) + "." + taken.name);
  return names;
}

/// Keeps at most maxCellLines of the lines, evenly spread. Returns words on how many are kept; "" if all are.
std::string thinLines(std::vector<ChartLine>& lines) {
  const std::size_t all = lines.size();
  if (all <= maxCellLines) return "";
  for (std::size_t k = 0; k < maxCellLines; ++k) std::swap(lines[k], lines[k * all / maxCellLines]);
  lines.resize(maxCellLines);
  return fmt::format(", {} of {}", maxCellLines, counted(all, "cell"));
}

/// Adds charts as `morula chart` draws them, but smaller.
void addOfOneRun(const RunFacts& run, Document& charts, std::vector<std::string>& commands, Json& live) {
  // The chart that is drawn has these lines for the page's program, and these words on how many are kept.
  std::string lines, kept;
  const auto add = [&](const std::string& what, std::string caption, const auto& draw) {
    try {
      const Drawing drawing = draw();
      caption += std::exchange(kept, "");
      Picture picture =
          svgPicture(drawing, caption, caption, what == "divisions" ? Picture::Size::wide : Picture::Size::usual);
      charts.add(enliven(picture, std::exchange(lines, ""), live));
      const std::string quoted = what.find(' ') == what.npos ? what : "'" + what + "'";
      commands.push_back(commandFor(run, "chart", quoted));
    } catch (const InputError&) {  // the run has no data for this chart
    }
  };
  for (const std::string& measure : moreMeasures(run))
    add(measure, titleOfMeasure(measure, run.scenario.units) + (measure.starts_with("cell.") ? ": each cell" : ""),
        [&] {
          Chart chart = seriesOf(run.results, readMeasure(measure, IfSeveral::first), run.scenario);
          const Units& units = run.scenario.units;
          Chart small = timeChart(titleOfMeasure(measure, units), shownUnit(units, unitOfMeasure(measure)).name, units);
          small.lines = std::move(chart.lines);
          kept = thinLines(small.lines);
          small.legend = std::move(chart.legend);
          const auto labelled = std::count_if(small.lines.begin(), small.lines.end(), [](const ChartLine& line) {
            return !line.label.empty() || !line.pointLabels.empty();
          });
          lines = liveOf(small);
          for (ChartLine& line : small.lines)
            if (labelled > static_cast<long>(maxLabels)) line.label.clear(), line.pointLabels.clear();
          return drawChart(small);
        });
  const auto living = std::count_if(run.results.lineage.begin(), run.results.lineage.end(),
                                    [](const LineageEntry& c) { return c.fate == Fate::alive; });
  if (living > 1 && living <= static_cast<long>(maxTouching))
    add("contacts", "Contact areas between cells at the end", [&] {
      MatrixPicture matrix = contactsOf(run.results, run.run.time, run.scenario);
      matrix.title = "Contacts", matrix.caption.clear();
      matrix.width = matrix.height = living > 20 ? 640 : width;
      return drawMatrix(matrix);
    });
  if (!run.results.divisions.empty())
    add("divisions", "Directions of the axes of divisions, towards daughter A", [&] {
      RosePicture roses = divisionsOf(run.results, run.scenario);
      roses.title = "Divisions", roses.caption.clear();
      roses.width = 640, roses.height = 300;
      return drawRoses(roses);
    });
}

}  // namespace

PageSection chartSection(const std::vector<RunFacts>& runs, Json& live) {
  PageSection section{"charts", "Charts", {}};
  Document charts;
  const auto add = [&](const Chart& chart, const std::string& what, const std::string& caption) {
    Picture picture = svgPicture(drawChart(chart), what, caption);
    charts.add(enliven(picture, liveOf(chart), live));
  };
  const Units units = unitsOfAll(runs, [](const RunFacts& r) { return r.scenario.units; });
  const std::size_t count = std::min(runs.size(), maxLines);
  Chart cells = timeChart("Living cells", "", units);
  for (std::size_t i = 0; i < count; ++i) addLine(cells, i, count, cellsOverTime(runs[i]), units);
  if (!cells.lines.empty())
    add(cells, "Living cells over time", "Number of living cells: each division adds one, each death takes one");
  const auto measures = sampledMeasures<Observation>();
  for (std::size_t m = 0; m < measures.size(); ++m) {
    const std::string measure = measures[m].name;
    if (measure == "cells") continue;
    const std::string title = titleOfMeasure(measure, units), unit = measures[m].unit;
    Chart chart = timeChart(title, shownUnit(units, unit).name, units);
    for (std::size_t i = 0; i < count; ++i) addLine(chart, i, count, measureOverTime(runs[i], m), units, unit);
    if (chart.lines.empty()) continue;
    add(chart, title + " over time", measures[m].meaning);
    if (count == 1) section.commands.push_back(commandFor(runs[0], "chart", measure + " -o " + measure + ".svg"));
  }
  if (count == 1) addOfOneRun(runs[0], charts, section.commands, live);
  else section.body.add(keyOf(runs, count));
  section.body.add(Group{Group::Kind::charts, "", std::move(charts)});
  if (runs.size() > maxLines)
    section.body.note("The first " + std::to_string(maxLines) + " of " + counted(runs.size(), "run") + ".");
  return section;
}

}  // namespace morula
