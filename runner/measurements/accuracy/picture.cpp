#include <fmt/format.h>

#include "accuracy/accuracy.h"
#include "base/number_text.h"
#include "drawing/palette.h"

namespace morula {

namespace {

constexpr Colour meshInk{0xa8, 0xad, 0xb3};

std::string stepLabel(double timeStep) {
  return timeStep < 1 ? fmt::format("1/{}", numberText(1 / timeStep, 5)) : numberText(timeStep, 5);
}

/// What the scenario's mesh itself costs: a line across all runs.
void addMesh(const AccuracyReport& report, Chart& chart) {
  const auto error = report.mesh.error();
  Range cost;
  for (const ChartLine& line : chart.lines)
    for (const Spot& p : line.points) cost.see(p.x);
  if (!error || !(*error > 0) || !(cost.low < cost.high)) return;
  chart.lines.push_back({"the mesh itself", meshInk, {{cost.low, *error}, {cost.high, *error}}, true, {}});
}

}  // namespace

Drawing drawAccuracy(const AccuracyReport& report) {
  Chart chart;
  chart.title = "Error against cost: " + report.scenario;
  chart.caption = fmt::format(
      "up to time {}; points: time steps, hollow: up to where other cells live; reference good to {:.1g}",
      numberText(report.times.back()), report.reference.left.error);
  chart.xLabel = "CPU time [s]";
  chart.yLabel = "error on the scenario's mesh [egg radii, relative volume]";
  chart.xScale = Axis::Scale::decades;
  std::vector<std::string> series;  // in the order of their colours; those beyond the colours are dashed
  for (const AccuracyRow& row : report.rows) {
    if (!row.error || !row.resolved || !(row.cpuSeconds > 0)) continue;
    if (series.empty() || series.back() != row.series) series.push_back(row.series);
    const Colour colour = seriesColour(series.size() - 1);
    const Spot point{row.cpuSeconds, *row.error};
    if (row.partedAt) {
      chart.marks.push_back({point, colour,
                             fmt::format("{}, {} until {}", row.series, stepLabel(row.setting.timeStep),
                                         numberText(*row.partedAt))});
      continue;
    }
    if (chart.lines.empty() || chart.lines.back().label != row.series)
      chart.lines.push_back({row.series, colour, {}, series.size() > fewSeries, {}});
    chart.lines.back().points.push_back(point);
    chart.lines.back().pointLabels.push_back(stepLabel(row.setting.timeStep));
  }
  addMesh(report, chart);
  return drawChart(chart);
}

}  // namespace morula
