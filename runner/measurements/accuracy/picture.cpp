#include <algorithm>
#include <cmath>

#include "accuracy/accuracy.h"
#include "base/number_text.h"
#include "drawing/palette.h"

namespace morula {
namespace {

constexpr Colour meshInk{0xa8, 0xad, 0xb3}, ownInk{0x20, 0x24, 0x28};
constexpr std::size_t maxPointLabels = 60;
constexpr std::size_t fewBullets = 4;  // max number of Bullet's series without omission of beaten ones

/// Returns true if another of Bullet's own series is better in both error and cost, at each point.
bool isBeaten(const std::string& series, const std::vector<AccuracyRow>& rows) {
  const auto counts = [](const AccuracyRow& row) {
    return row.engine != MeasuredEngine::morula && row.error && row.failure.empty();
  };
  return std::ranges::all_of(rows, [&](const AccuracyRow& row) {
    return row.series != series || !counts(row) || std::ranges::any_of(rows, [&](const AccuracyRow& other) {
             return counts(other) && other.series != series && *other.error <= *row.error &&
                    other.cpuSeconds <= row.cpuSeconds;
           });
  });
}

/// Removes labels if there are very many points, so that only the ends of lines have words.
void thinLabels(Chart& chart) {
  std::size_t points = 0;
  for (const ChartLine& line : chart.lines) points += line.points.size();
  if (points <= maxPointLabels) return;
  for (ChartLine& line : chart.lines)
    for (std::size_t k = 1; k + 1 < line.pointLabels.size(); ++k) line.pointLabels[k].clear();
}

}  // namespace

std::vector<std::string> beatenBullets(const AccuracyReport& report) {
  std::vector<std::string> bullets;
  for (const AccuracyRow& row : report.rows)
    if (row.engine != MeasuredEngine::morula && (bullets.empty() || bullets.back() != row.series))
      bullets.push_back(row.series);
  if (bullets.size() <= fewBullets) return {};
  std::erase_if(bullets, [&](const std::string& series) { return !isBeaten(series, report.rows); });
  return bullets;
}

Drawing drawAccuracy(const AccuracyReport& report) {
  Chart chart;
  chart.title = "Error against cost: " + report.scenario;
  chart.caption = "up to time " + numberText(report.times.back(), 6) +
                  "; points: time steps; hollow: compared until other "
                  "cells live";
  if (std::isfinite(report.reference.left.error))
    chart.caption += "; reference good to " + numberText(report.reference.left.error, 1);
  chart.xLabel = "CPU time [s]", chart.yLabel = "error on the scenario's mesh [egg radii, relative volume]";
  chart.xScale = Axis::Scale::decades;
  const auto beaten = beatenBullets(report);
  std::vector<std::string> series;  // in the order of their colours; further series are dashed
  Range cost;
  for (const AccuracyRow& row : report.rows) {
    if (!row.error || !(*row.error > 0) || !(row.cpuSeconds > 0) || !row.resolved || !row.failure.empty() ||
        std::ranges::find(beaten, row.series) != beaten.end())
      continue;
    if (series.empty() || series.back() != row.series) series.push_back(row.series);
    const Colour colour = seriesColour(series.size() - 1);
    const Spot point{row.cpuSeconds, *row.error};
    if (row.partedAt) {
      chart.marks.push_back(
          {point, colour, row.series + ", " + stepText(row.setting.timeStep) + " until " + numberText(*row.partedAt)});
      continue;
    }
    cost.see(row.cpuSeconds);
    if (chart.lines.empty() || chart.lines.back().label != row.series)
      chart.lines.push_back({row.series, colour, {}, series.size() > fewSeries, {}});
    chart.lines.back().points.push_back(point);
    chart.lines.back().pointLabels.push_back(stepText(row.setting.timeStep));
  }
  thinLabels(chart);
  // The error of the scenario's mesh itself is a line across all runs.
  if (const auto mesh = report.mesh.error(); mesh && *mesh > 0 && cost.low < cost.high)
    chart.lines.push_back({"the mesh itself", meshInk, {{cost.low, *mesh}, {cost.high, *mesh}}, true, {}});
  if (const AccuracyRow& own = report.own; own.resolved && own.error && *own.error > 0 && own.cpuSeconds > 0)
    chart.marks.push_back({{own.cpuSeconds, *own.error}, ownInk, "as it is"});
  return drawChart(chart);
}

}  // namespace morula
