// The measurements of a bench, for people.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bench/bench.h"
#include "drawing/palette.h"

namespace morula {
namespace {

Cell fixed(double value, int digits) { return {value, fmt::format("{:.{}f}", value, digits)}; }

std::string size(std::size_t bytes) {
  return bytes < (1u << 20) ? fmt::format("{} KiB", bytes >> 10) : fmt::format("{} MiB", bytes >> 20);
}

Table machine(const MachineLimits& limits) {
  Table table{"Limits of this machine", {}};
  for (const auto& [isa, a] : limits.arithmetic)
    table.rows.push_back(
        {name(isa), fmt::format("{:.1f} G multiplications and additions/s, {:.2f} G roots with division/s, "
                                "{:.1f} G instructions/s",
                                1e-9 * a.operations, 1e-9 * a.roots, 1e-9 * a.instructions)});
  std::string rates;
  for (const auto& [bytes, rate] : limits.bandwidth)
    rates += fmt::format("{}{} {:.0f}", rates.empty() ? "" : ", ", size(bytes), 1e-9 * rate);
  table.rows.push_back({"memory", rates + " GB/s"});
  return table;
}

/// Returns true for rows of one scene.
bool sameScene(const BenchRow& a, const BenchRow& b) {
  return a.scene == b.scene && a.cells == b.cells && a.vertices == b.vertices;
}

using Rows = std::vector<const BenchRow*>;

std::vector<std::string> isasOf(const std::vector<BenchRow>& rows) {
  std::vector<std::string> isas;
  for (const BenchRow& row : rows)
    if (!row.isa.empty() && std::find(isas.begin(), isas.end(), row.isa) == isas.end()) isas.push_back(row.isa);
  return isas;
}

std::string labelOf(const BenchRow& row) {
  if (row.engine != MeasuredEngine::morula)
    return row.engine == MeasuredEngine::scalar ? "internal, ordinary code" : nameOf(row.engine);
  std::string label = nameOf(row.stage);
  if (row.wallClock) return fmt::format("{}, {}, wall", label, counted(std::uint64_t(row.threads), "thread"));
  return row.search.empty() ? label : label + ", " + row.search;
}

/// Describes Bullet's best settings and the times of its other settings, or the time of a search or choice.
std::string noteOf(const BenchRow& row) {
  if (row.nsPerVertexOnce)
    return fmt::format("{:.0f} ns/{}", *row.nsPerVertexOnce, row.stage == Stage::rebuild ? "search" : "choice");
  if (row.bulletSettings.empty()) return "";
  const BulletSettingRow &best = row.bulletSettings.front(), &worst = row.bulletSettings.back();
  return fmt::format("margin {:g}, {}; {:.0f} to {:.0f} over {} settings", best.margin,
                     counted(std::uint64_t(best.iterations), "iteration"), best.nsPerVertexStep, worst.nsPerVertexStep,
                     row.bulletSettings.size());
}

std::string often(const char* what, double perStep) {
  return perStep > 0 ? fmt::format("a {} every {:.0f} steps", what, 1 / perStep) : fmt::format("no {} was due", what);
}

std::string heading(const Rows& rows) {
  const BenchRow& row = *rows.front();
  const std::string text = fmt::format("{} scene, {} cells of {} vertices", row.scene, row.cells, row.vertices);
  for (const BenchRow* r : rows)
    if (r->pairsPerVertexStep)
      return text + fmt::format(": {:.2f} pairs per vertex, {:.2f} of them chosen; ", *r->pairsPerVertexStep,
                                *r->slotsPerVertexStep) +
             often("search", *r->rebuildsPerStep) + ", " + often("choice of pairs", *r->choicesPerStep);
  return text;
}

/// Returns a table with a stage's times on every instruction set in one row.
Table sceneTable(const Rows& rows, const std::vector<std::string>& isas) {
  Table table{"Times of a scene", {"ns per vertex and step"}};
  for (const std::string& isa : isas) table.columns.insert(table.columns.end(), {isa, "limit"});
  table.columns.push_back("");
  for (const BenchRow* row : rows) {
    const std::string label = labelOf(*row);
    auto known = std::ranges::find(table.rows, label, [](const auto& cells) { return cells[0].words.text(); });
    if (known == table.rows.end()) {
      known = table.rows.emplace(known, table.columns.size(), Cell({}, " "));
      (*known)[0] = label;
    }
    auto& cells = *known;
    const auto isa = static_cast<std::size_t>(std::ranges::find(isas, row->isa) - isas.begin());
    const std::size_t place = isa < isas.size() ? 1 + 2 * isa : 1;
    cells[place] = fixed(row->nsPerVertexStep, 2);
    if (row->limit)
      cells[place + 1] = {*row->shareOfLimit,
                          fmt::format("{:.0f} % {}", 100 * *row->shareOfLimit, nameOf(row->limit->bound()))};
    cells.back() = noteOf(*row);
  }
  return table;
}

void addScenes(const std::vector<BenchRow>& rows, Document& text) {
  const auto isas = isasOf(rows);
  for (std::size_t first = 0; first < rows.size();) {
    Rows same;
    while (first < rows.size() && (same.empty() || sameScene(*same.front(), rows[first])))
      same.push_back(&rows[first++]);
    text.heading(heading(same)).add(sceneTable(same, isas));
  }
}

/// Adds the growth of times with the number of cells, Morula's and the thesis', each relative to its own 8 cells.
void addThesis(const std::vector<BenchRow>& rows, Document& text) {
  const auto isas = isasOf(rows);
  if (isas.empty()) return;
  const auto ours = [&](int cells) {
    return find(rows, "packed", MeasuredEngine::morula, Stage::step, cells, 162, isas.back());
  };
  const BenchRow* eight = ours(8);
  Table table{"Cost of a cell and step", {"cells", "thesis [ms]", "over 8 cells", "morula [µs]", "over 8 cells"}};
  for (const ThesisRow& row : thesisTable) {
    const BenchRow* own = ours(row.cells);
    table.rows.push_back({row.cells, fixed(row.msPerCell, 2), fixed(row.msPerCell / thesisTable[0].msPerCell, 2),
                          own ? fixed(1e-3 * own->nsPerVertexStep * own->vertices, 2) : Cell({}, " "),
                          own && eight ? fixed(own->nsPerVertexStep / eight->nsPerVertexStep, 2) : Cell({}, " ")});
  }
  text.heading(fmt::format("cost of a cell and step: thesis, table 5.1 (2008); morula {}, one thread", isas.back()))
      .add(std::move(table));
}

void addRatios(const std::vector<BenchRatio>& ratios, Document& text) {
  if (ratios.empty()) return;
  Table table{"Ratios within this run", {}};
  for (const BenchRatio& r : ratios)
    table.rows.push_back({r.what, fixed(r.value, 2), fmt::format("{} {:.3g}", r.atLeast ? "≥" : "≤", r.bound),
                          !r.notJudged.empty() ? "not judged: " + r.notJudged
                          : r.holds()          ? "holds"
                                               : "does not hold"});
  text.heading("ratios within this run").add(std::move(table));
}

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

Document describe(const BenchReport& report) {
  Document text;
  text.say("one thread of this machine, in this run").add(machine(report.machine));
  addScenes(report.rows, text);
  addThesis(report.rows, text);
  addRatios(report.ratios, text);
  for (const std::string& remark : report.remarks) text.heading(remark);
  return text;
}

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
    const std::string label = nameOf(row.engine) + (row.isa.empty() ? "" : " " + row.isa);
    add(label, {double(row.cells), row.nsPerVertexStep});
    if (row.engine == MeasuredEngine::morula) widest = row.isa;
  }
  ChartLine ordinary{"ordinary code, inner forces only", {0x77, 0x77, 0x77}, {}, true};
  for (const BenchRow& row : report.rows)
    if (row.engine == MeasuredEngine::scalar && row.vertices == verticesShown)
      ordinary.points.push_back({double(row.cells), row.nsPerVertexStep});
  if (!ordinary.points.empty()) chart.lines.push_back(ordinary);
  if (const BenchRow* eight =
          find(report.rows, "packed", MeasuredEngine::morula, Stage::step, 8, verticesShown, widest)) {
    ChartLine thesis{"thesis' table 5.1, scaled", seriesColour(2), {}, true};
    for (const ThesisRow& row : thesisTable)
      thesis.points.push_back({double(row.cells), eight->nsPerVertexStep * row.msPerCell / thesisTable[0].msPerCell});
    chart.lines.push_back(thesis);
  }
  return drawChart(chart);
}

}  // namespace morula
