#include "bench/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace morula {

namespace {

std::string number(const std::optional<double>& value, const char* form) {
  return value ? fmt::format(fmt::runtime(form), *value) : "–";
}

std::string machine(const MachineLimits& limits) {
  std::string text = "machine, one thread";
  for (const auto& [isa, a] : limits.arithmetic)
    text += fmt::format(
        "\n  {:<7} {:6.1f} G multiplications and additions per second, {:5.2f} G roots with division",
        name(isa), 1e-9 * a.operations, 1e-9 * a.roots);
  for (const auto& [bytes, rate] : limits.bandwidth)
    text += fmt::format(
        "\n  {:>7} {:6.1f} GB/s to and fro",
        bytes < (1u << 20) ? fmt::format("{} KiB", bytes >> 10) : fmt::format("{} MiB", bytes >> 20),
        1e-9 * rate);
  return text + "\n\n";
}

std::string line(const BenchRow& r) {
  std::string engine = r.engine + (r.isa.empty() ? "" : " " + r.isa);
  if (r.wallClock) engine += fmt::format(" {}t wall", r.threads);
  const std::string stage = name(r.stage) + (r.search.empty() ? "" : " " + r.search);
  return fmt::format("{:<16}{:<20}{:<22}{:>6}{:>6}{:>11.2f}{:>7.1f}{:>8}{:>8}{:>9}{:>9}{:>10}\n", r.scene,
                     engine, stage, r.cells, r.vertices, r.nsPerVertexStep, 100 * r.spread,
                     number(r.shareOfLimit, "{:.2f}"), number(r.shareOfPeak, "{:.2f}"),
                     number(r.pairsPerVertexStep, "{:.2f}"), number(r.rebuildsPerStep, "{:.4f}"),
                     number(r.nsPerVertexSearch, "{:.1f}"));
}

/// How either grows with the number of cells, each in units of its own 8 cells.
std::string thesis(const std::vector<BenchRow>& rows) {
  const BenchRow* widest = nullptr;
  for (const BenchRow& row : rows)
    if (row.scene == "packed" && row.engine == "morula" && row.stage == Stage::step && !row.wallClock &&
        row.vertices == 162)
      widest = &row;  // the last one is of the widest instruction set
  if (!widest) return "";
  const auto ours = [&](int cells) {
    return find(rows, "packed", "morula", Stage::step, cells, 162, widest->isa);
  };
  std::string text = fmt::format(
      "\nper cell and step           thesis, table 5.1 (2008)      morula {}\n"
      "cells                        ms      over 8 cells        µs      over 8 cells\n",
      widest->isa);
  const BenchRow* eight = ours(8);
  for (const ThesisRow& row : thesisTable) {
    const BenchRow* own = ours(row.cells);
    text += fmt::format("{:<24}{:>8.2f}{:>12.2f}", row.cells, row.msPerCell,
                        row.msPerCell / thesisTable[0].msPerCell);
    if (own) {
      text += fmt::format("{:>18.2f}", 1e-3 * own->nsPerVertexStep * own->vertices);
      if (eight) text += fmt::format("{:>12.2f}", own->nsPerVertexStep / eight->nsPerVertexStep);
    }
    text += "\n";
  }
  return text;
}

std::string ratios(const std::vector<BenchRatio>& list) {
  if (list.empty()) return "";
  std::string text = "\nratios within this run\n";
  for (const BenchRatio& r : list)
    text += fmt::format("  {:<74}{:>8.2f}   {} {:<6.3g} {}\n", r.what, r.value, r.atLeast ? "≥" : "≤",
                        r.bound, r.holds() ? "holds" : "DOES NOT HOLD");
  return text;
}

}  // namespace

std::string describe(const BenchReport& report) {
  std::string text = machine(report.machine);
  text += fmt::format("{:<16}{:<20}{:<22}{:>6}{:>6}{:>11}{:>7}{:>8}{:>8}{:>9}{:>9}{:>10}\n", "scene",
                      "engine", "stage", "cells", "verts", "ns/v-step", "± %", "limit", "peak", "pairs/v",
                      "searches", "ns/search");
  for (const BenchRow& row : report.rows) text += line(row);
  text += thesis(report.rows) + ratios(report.ratios);
  for (const std::string& remark : report.remarks) text += remark + "\n";
  return text;
}

}  // namespace morula
