#include <map>

#include "bench/bench.h"
#include "drawing/palette.h"

namespace morula {
namespace {

constexpr int verticesShown = 162;

Colour colourOf(const std::string& line) {
  static const std::map<std::string, Colour> colours{
      {"morula scalar", {0x9e, 0xb9, 0xd4}}, {"morula narrow", {0x6a, 0x9c, 0xc9}}, {"morula avx2", {0x2f, 0x78, 0xb5}},
      {"morula avx512", {0x0b, 0x3c, 0x6f}}, {"bullet-b1", seriesColour(1)},        {"bullet-b2", seriesColour(4)},
  };
  const auto found = colours.find(line);
  return found == colours.end() ? Colour{0x55, 0x55, 0x55} : found->second;
}

}  // namespace

Drawing drawBench(const BenchReport& report) {
  Chart chart;
  chart.title = "Cost of a step";
  chart.caption = "whole steps of packed cells of 162 vertices, one thread, double precision; medians of one run";
  chart.xLabel = "cells";
  chart.yLabel = "ns per vertex and step";
  const auto add = [&](const std::string& label, Spot point) {
    for (ChartLine& line : chart.lines)
      if (line.label == label) return line.points.push_back(point);
    chart.lines.push_back({label, colourOf(label), {point}});
  };
  std::string widest;
  for (const BenchRow& row : report.rows) {
    if (row.scene != "packed" || row.stage != Stage::step || row.vertices != verticesShown || row.wallClock) continue;
    const std::string label = row.isa.empty() ? row.engine : row.engine + " " + row.isa;
    add(label, {double(row.cells), row.nsPerVertexStep});
    if (row.engine == "morula") widest = row.isa;
  }
  ChartLine ordinary{"ordinary code, inner forces only", {0x77, 0x77, 0x77}, {}, true};
  for (const BenchRow& row : report.rows)
    if (row.engine == "scalar" && row.vertices == verticesShown)
      ordinary.points.push_back({double(row.cells), row.nsPerVertexStep});
  if (!ordinary.points.empty()) chart.lines.push_back(ordinary);
  if (const BenchRow* eight = find(report.rows, "packed", "morula", Stage::step, 8, verticesShown, widest)) {
    ChartLine thesis{"thesis' table 5.1, scaled", seriesColour(2), {}, true};
    for (const ThesisRow& row : thesisTable)
      thesis.points.push_back({double(row.cells), eight->nsPerVertexStep * row.msPerCell / thesisTable[0].msPerCell});
    chart.lines.push_back(thesis);
  }
  return drawChart(chart);
}

}  // namespace morula
