#include <fmt/format.h>

#include <algorithm>

#include "bench/bench.h"

namespace morula {

namespace {

constexpr int columnWidth = 17;

std::string size(std::size_t bytes) {
  return bytes < (1u << 20) ? fmt::format("{} KiB", bytes >> 10) : fmt::format("{} MiB", bytes >> 20);
}

std::string machine(const MachineLimits& limits) {
  std::string text = "one thread of this machine, in this run\n";
  for (const auto& [isa, a] : limits.arithmetic)
    text += fmt::format("  {:<9}{:5.1f} G multiplications and additions/s, {:.2f} G roots with division/s\n",
                        name(isa), 1e-9 * a.operations, 1e-9 * a.roots);
  text += "  memory   ";
  for (const auto& [bytes, rate] : limits.bandwidth)
    text += fmt::format("{}{} {:.0f}", bytes == limits.bandwidth.begin()->first ? "" : ", ", size(bytes),
                        1e-9 * rate);
  return text + " GB/s\n";
}

/// The rows of one scene stand together.
bool sameScene(const BenchRow& a, const BenchRow& b) {
  return a.scene == b.scene && a.cells == b.cells && a.vertices == b.vertices;
}

using Rows = std::vector<const BenchRow*>;

std::vector<std::string> isasOf(const std::vector<BenchRow>& rows) {
  std::vector<std::string> isas;
  for (const BenchRow& row : rows)
    if (!row.isa.empty() && std::find(isas.begin(), isas.end(), row.isa) == isas.end())
      isas.push_back(row.isa);
  return isas;
}

std::string cell(const BenchRow& row) {
  return fmt::format("{:.2f}", row.nsPerVertexStep) +
         (row.shareOfLimit ? fmt::format(" {:>4.0f} %", 100 * *row.shareOfLimit) : "       ");
}

/// One line: a stage's times on every instruction set.
std::string line(const std::string& label, const Rows& rows, const std::vector<std::string>& isas) {
  std::string text = fmt::format("  {:<22}", label);
  for (const auto& isa : isas) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const BenchRow* r) { return r->isa == isa; });
    text += fmt::format("{:>{}}", row == rows.end() ? "" : cell(**row), columnWidth);
  }
  return text;
}

std::string labelOf(const BenchRow& row) {
  std::string label = nameOf(row.stage);
  if (row.wallClock)
    return fmt::format("{}, {} thread{}, wall", label, row.threads, row.threads == 1 ? "" : "s");
  return row.search.empty() ? label : label + ", " + row.search;
}

/// What Bullet was at its best with, and what its other settings took.
std::string settings(const BenchRow& row) {
  if (row.bulletSettings.empty()) return "";
  const BulletSettingRow &best = row.bulletSettings.front(), &worst = row.bulletSettings.back();
  return fmt::format("   margin {:g}, {} iteration{}; {:.0f} to {:.0f} over {} settings", best.margin,
                     best.iterations, best.iterations == 1 ? "" : "s", best.nsPerVertexStep,
                     worst.nsPerVertexStep, row.bulletSettings.size());
}

std::string heading(const BenchRow& row, const Rows& rows) {
  std::string text = fmt::format("\n{} scene, {} cells of {} vertices", row.scene, row.cells, row.vertices);
  for (const BenchRow* r : rows)
    if (r->pairsPerVertexStep) {
      text += fmt::format(": {:.2f} pairs per vertex, ", *r->pairsPerVertexStep);
      return text + (*r->rebuildsPerStep > 0
                         ? fmt::format("a search every {:.0f} steps\n", 1 / *r->rebuildsPerStep)
                         : "no search fell due\n");
    }
  return text + "\n";
}

std::string scene(const Rows& rows, const std::vector<std::string>& isas) {
  std::string text = heading(*rows.front(), rows);
  std::vector<std::string> done;
  for (const BenchRow* row : rows) {
    const std::string label = labelOf(*row);
    if (row->engine != "morula") {
      text += fmt::format("  {:<22}{:>10.2f}{}\n",
                          row->engine == "scalar" ? "internal, ordinary code" : row->engine,
                          row->nsPerVertexStep, settings(*row));
      continue;
    }
    if (std::find(done.begin(), done.end(), label) != done.end()) continue;
    done.push_back(label);
    Rows alike;
    for (const BenchRow* r : rows)
      if (r->engine == "morula" && labelOf(*r) == label) alike.push_back(r);
    text += line(label, alike, isas);
    if (const auto& search = alike.back()->nsPerVertexSearch)
      text += fmt::format("   {:.0f} ns/search", *search);
    text += "\n";
  }
  return text;
}

std::string scenes(const std::vector<BenchRow>& rows) {
  const auto isas = isasOf(rows);
  std::string text = fmt::format("\n{:<24}", "ns per vertex and step");
  for (const auto& isa : isas) text += fmt::format("{:>{}}", isa + "  limit", columnWidth);
  text += "\n";
  for (std::size_t first = 0; first < rows.size();) {
    Rows same;
    for (; first + same.size() < rows.size() && sameScene(rows[first], rows[first + same.size()]);)
      same.push_back(&rows[first + same.size()]);
    text += scene(same, isas);
    first += same.size();
  }
  return text;
}

/// How either grows with the number of cells, each in units of its own 8 cells.
std::string thesis(const std::vector<BenchRow>& rows) {
  const auto isas = isasOf(rows);
  if (isas.empty()) return "";
  const auto ours = [&](int cells) {
    return find(rows, "packed", "morula", Stage::step, cells, 162, isas.back());
  };
  const BenchRow* eight = ours(8);
  std::string text = fmt::format(
      "\ncost of a cell and step     thesis, table 5.1 (2008)     morula {}, one thread\n"
      "  cells                         ms   over 8 cells             µs   over 8 cells\n",
      isas.back());
  for (const ThesisRow& row : thesisTable) {
    text += fmt::format("  {:<22}{:>10.2f}{:>15.2f}", row.cells, row.msPerCell,
                        row.msPerCell / thesisTable[0].msPerCell);
    if (const BenchRow* own = ours(row.cells)) {
      text += fmt::format("{:>15.2f}", 1e-3 * own->nsPerVertexStep * own->vertices);
      if (eight) text += fmt::format("{:>15.2f}", own->nsPerVertexStep / eight->nsPerVertexStep);
    }
    text += "\n";
  }
  return text;
}

std::string ratios(const std::vector<BenchRatio>& list) {
  if (list.empty()) return "";
  std::string text = "\nratios within this run\n";
  for (const BenchRatio& r : list)
    text +=
        fmt::format("  {:<72}{:>8.2f}   {} {:<5.3g} {}\n", r.what, r.value, r.atLeast ? "≥" : "≤", r.bound,
                    !r.notJudged.empty() ? "not judged: " + r.notJudged
                    : r.holds()          ? "holds"
                                         : "does not hold");
  return text;
}

}  // namespace

std::string describe(const BenchReport& report) {
  std::string text =
      machine(report.machine) + scenes(report.rows) + thesis(report.rows) + ratios(report.ratios);
  for (const std::string& remark : report.remarks) text += "\n" + remark + "\n";
  return text;
}

}  // namespace morula
