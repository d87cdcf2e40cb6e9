#include "accuracy/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "charts/chart.h"

namespace morula {

namespace {

// No two alike, neighbours far apart; the first eight for people who see few colours too. Lines beyond those
// are dashed.
constexpr Colour colours[] = {{0x0b, 0x3c, 0x6f}, {0xc0, 0x39, 0x2b}, {0xe0, 0x8a, 0x3c}, {0x5c, 0x8a, 0x3a},
                              {0x6a, 0x3d, 0x9a}, {0x2f, 0x9c, 0xb5}, {0x77, 0x77, 0x77}, {0xb5, 0x65, 0x9c},
                              {0x1c, 0x1c, 0x1c}, {0xc9, 0xa2, 0x0a}, {0x45, 0x6a, 0xd4}, {0x7a, 0x3e, 0x12},
                              {0x12, 0x7d, 0x64}, {0xe4, 0x72, 0xa2}, {0x80, 0x00, 0x20}, {0x93, 0xbf, 0x2a},
                              {0xff, 0x5a, 0x1f}, {0x00, 0xc0, 0xa0}, {0xc4, 0x26, 0xcf}, {0x9b, 0x86, 0x62},
                              {0x2a, 0x4a, 0x2a}, {0x86, 0xa4, 0xd8}, {0x5c, 0x5a, 0x14}, {0x3b, 0x0a, 0x5e}};
constexpr std::size_t plain = 8;
constexpr Colour meshInk{0xa8, 0xad, 0xb3};

std::string stepLabel(double timeStep) {
  return timeStep < 1 ? fmt::format("1/{}", numberText(1 / timeStep, 5)) : numberText(timeStep, 5);
}

/// What the scenario's mesh itself costs: a line across all runs.
void addMesh(const AccuracyReport& report, Chart& chart) {
  const auto error = report.mesh.error();
  Spot range{INFINITY, 0};  // of the CPU times
  for (const ChartLine& line : chart.lines)
    for (const Spot& p : line.points) range = {std::min(range.x, p.x), std::max(range.y, p.x)};
  if (!error || !(*error > 0) || !(range.x < range.y)) return;
  chart.lines.push_back({"the mesh itself", meshInk, {{range.x, *error}, {range.y, *error}}, true, {}});
}

}  // namespace

Colour seriesColour(std::size_t number) { return colours[number % std::size(colours)]; }

Image drawAccuracy(const AccuracyReport& report) {
  Chart chart;
  chart.title = "Error against cost: " + report.scenario;
  chart.caption = fmt::format(
      "up to time {}; points: time steps, hollow: up to where other cells live; reference good to {:.1g}",
      numberText(report.times.back()), report.reference.left.error);
  chart.xLabel = "CPU time [s]";
  chart.yLabel = "error on the scenario's mesh [egg radii, relative volume]";
  chart.xScale = Chart::Scale::decades;
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
      chart.lines.push_back({row.series, colour, {}, series.size() > plain, {}});
    chart.lines.back().points.push_back(point);
    chart.lines.back().pointLabels.push_back(stepLabel(row.setting.timeStep));
  }
  addMesh(report, chart);
  return drawChart(chart);
}

}  // namespace morula
