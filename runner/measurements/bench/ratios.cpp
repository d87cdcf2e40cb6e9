#include <fmt/format.h>

#include <set>
#include <tuple>

#include "bench/bench.h"

namespace morula {
namespace {

constexpr int cellVertices = 162;

class BenchTable {
 public:
  explicit BenchTable(const std::vector<BenchRow>& rows) : rows_(rows) {
    for (const BenchRow& row : rows) {
      if (row.engine == MeasuredEngine::morula) isas_.insert(row.isa);
      cells_.insert(row.cells);
    }
  }
  const BenchRow* packed(Stage stage, int cells, const std::string& isa, int threads = 1, bool wall = false) const {
    return find(rows_, "packed", MeasuredEngine::morula, stage, cells, cellVertices, isa, threads, wall);
  }
  /// Returns the row of one thread.
  const BenchRow* row(const std::string& scene, MeasuredEngine engine, Stage stage, int cells,
                      const std::string& isa = "") const {
    return find(rows_, scene, engine, stage, cells, cellVertices, isa);
  }
  const std::set<std::string>& isas() const { return isas_; }
  const std::set<int>& cells() const { return cells_; }
  /// Returns the instruction set of the bounds: AVX2, or else the last available one.
  std::string reference() const { return isas_.contains("avx2") || isas_.empty() ? "avx2" : *isas_.rbegin(); }

 private:
  const std::vector<BenchRow>& rows_;
  std::set<std::string> isas_;
  std::set<int> cells_;
};

double ns(const BenchRow& row) { return row.nsPerVertexStep; }

void againstBullet(const BenchTable& t, std::vector<BenchRatio>& ratios) {
  const std::pair<const char*, Precision> scenes[] = {{"packed", Precision::binary64},
                                                      {"packed-single", Precision::binary32}};
  for (const int cells : {64, 128, 256})
    for (const auto& [scene, precision] : scenes) {
      const BenchRow *ours = t.row(scene, MeasuredEngine::morula, Stage::step, cells, t.reference()),
                     *bullet = t.row(scene, MeasuredEngine::bulletB1, Stage::step, cells);
      if (ours && bullet)
        ratios.push_back({fmt::format("Bullet B1's step over Morula's, both in {} precision, {} cells, {}",
                                      nameOf(precision), cells, t.reference()),
                          ns(*bullet) / ns(*ours), 25, true});
    }
}

void againstOrdinaryCode(const BenchTable& t, std::vector<BenchRatio>& ratios) {
  const BenchRow* ordinary = t.row("packed", MeasuredEngine::scalar, Stage::internal, 64);
  if (!ordinary) return;
  const std::pair<int, double> promised[] = {{64, 1}, {512, 75.0 / 45}, {2048, 95.0 / 45}};
  for (const auto& [cells, most] : promised)
    if (const BenchRow* step = t.packed(Stage::step, cells, t.reference()))
      ratios.push_back(
          {fmt::format("whole step of {} cells over inner forces of ordinary code, {}", cells, t.reference()),
           ns(*step) / ns(*ordinary), most, false});
}

void scaling(const BenchTable& t, std::vector<BenchRatio>& ratios) {
  for (const auto& [many, few, most] : {std::tuple{256, 128, 1.4}, {2048, 64, 2.2}}) {
    const BenchRow *large = t.packed(Stage::step, many, t.reference()),
                   *small = t.packed(Stage::step, few, t.reference());
    if (large && small)
      ratios.push_back({fmt::format("ns per vertex and step, {} over {} cells, {}", many, few, t.reference()),
                        ns(*large) / ns(*small), most, false});
  }
}

void kernels(const BenchTable& t, std::vector<BenchRatio>& ratios) {
  for (const std::string& isa : t.isas()) {
    const BenchRow* row = t.packed(Stage::internal, 64, isa);
    if (row && row->shareOfPeak)
      ratios.push_back({fmt::format("inner forces, share of the multiply–add peak, 64 cells, {}", isa),
                        *row->shareOfPeak, 0.7, true});
    if (row && row->shareWithRoots)
      ratios.push_back(
          {fmt::format("inner forces, share of the peak with an edge's root and quotient counted, 64 cells, {}", isa),
           *row->shareWithRoots, 0.7, true, "shown to explain the share of the multiply–add peak"});
    const BenchRow *step = t.row("free", MeasuredEngine::morula, Stage::step, 64, isa),
                   *internal = t.row("free", MeasuredEngine::morula, Stage::internal, 64, isa);
    if (step && internal)
      ratios.push_back({fmt::format("step without contact over inner forces, 64 cells, {}", isa),
                        ns(*step) / ns(*internal), 1.1, false});
  }
}

void threads(const BenchTable& t, std::vector<BenchRatio>& ratios) {
  for (const int cells : t.cells())
    for (const std::string& isa : t.isas()) {
      const BenchRow *one = t.packed(Stage::step, cells, isa, 1, true),
                     *two = t.packed(Stage::step, cells, isa, 2, true);
      if (!one || !two) continue;
      BenchRatio ratio{fmt::format("two threads over one, {} cells, {}", cells, isa), ns(*one) / ns(*two),
                       cells >= 512 ? 1.6 : 1, true};
      if (two->processors && *two->processors < 1.8)
        ratio.notJudged = fmt::format("other programs left only {:.1f} processors", *two->processors);
      ratios.push_back(ratio);
    }
}

}  // namespace

std::vector<BenchRatio> findRatios(const std::vector<BenchRow>& rows) {
  const BenchTable table(rows);
  std::vector<BenchRatio> ratios;
  againstBullet(table, ratios);
  againstOrdinaryCode(table, ratios);
  scaling(table, ratios);
  kernels(table, ratios);
  threads(table, ratios);
  return ratios;
}

}  // namespace morula
