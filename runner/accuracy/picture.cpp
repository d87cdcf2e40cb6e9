#include "accuracy/picture.h"

#include <fmt/format.h>

#include "base/number_text.h"
#include "bench/chart.h"

namespace morula {

namespace {

// Apart for people who see few colours too.
constexpr Colour colours[] = {{0x0b, 0x3c, 0x6f}, {0xc0, 0x39, 0x2b}, {0xe0, 0x8a, 0x3c}, {0x5c, 0x8a, 0x3a},
                              {0x6a, 0x3d, 0x9a}, {0x2f, 0x9c, 0xb5}, {0x77, 0x77, 0x77}, {0xb5, 0x65, 0x9c}};

std::string stepLabel(double timeStep) {
  return timeStep < 1 ? fmt::format("1/{}", numberText(1 / timeStep, 5)) : numberText(timeStep, 5);
}

}  // namespace

Image drawAccuracy(const AccuracyReport& report) {
  Chart chart;
  chart.title = "Error against cost: " + report.scenario;
  chart.caption = fmt::format(
      "up to time {}; points are labelled with their time steps, hollow ones up to where other cells live; "
      "reference good to {:.1g}",
      numberText(report.times.back()), report.reference.left.error);
  chart.xLabel = "CPU time [s]";
  chart.yLabel = "largest error of centroids, surfaces [egg radii] and volumes";
  chart.xScale = Chart::Scale::decades;
  std::vector<std::string> series;  // in the order of their colours; those beyond the colours are dashed
  for (const AccuracyRow& row : report.rows) {
    if (!row.error || !row.resolved || !(row.cpuSeconds > 0)) continue;
    if (series.empty() || series.back() != row.series) series.push_back(row.series);
    const Colour colour = colours[(series.size() - 1) % std::size(colours)];
    const Spot point{row.cpuSeconds, *row.error};
    if (row.partedAt) {
      chart.marks.push_back({point, colour,
                             fmt::format("{}, {} until {}", row.series, stepLabel(row.setting.timeStep),
                                         numberText(*row.partedAt))});
      continue;
    }
    if (chart.lines.empty() || chart.lines.back().label != row.series)
      chart.lines.push_back({row.series, colour, {}, series.size() > std::size(colours), {}});
    chart.lines.back().points.push_back(point);
    chart.lines.back().pointLabels.push_back(stepLabel(row.setting.timeStep));
  }
  return drawChart(chart);
}

}  // namespace morula
