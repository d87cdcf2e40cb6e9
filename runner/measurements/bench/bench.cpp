#include "bench/bench.h"

#include "bench/scene_bench.h"
#include "engines/bullet_scene.h"

namespace morula {
namespace {

std::vector<PlannedScene> plan(const BenchOptions& options) {
  std::vector<PlannedScene> scenes;
  for (const int cells : options.cells)
    for (const int level : options.levels) {
      scenes.push_back({{.cells = cells, .level = level}, "packed", true});
      scenes.push_back({{.cells = cells, .level = level, .friction = 0.3}, "packed-friction", false});
      scenes.push_back({{.cells = cells, .level = level, .precision = Precision::binary32}, "packed-single", false});
      scenes.push_back({{.cells = cells, .level = level, .contact = false}, "free", false});
    }
  for (const int level : options.extraLevels)
    scenes.push_back({{.cells = options.extraCells, .level = level}, "packed", true});
  return scenes;
}

void addShares(BenchRow& row, const MachineLimits& limits) {
  if (!row.work) return;
  const Isa isa = parseIsa(row.isa);
  const double time = 1e-9 * row.nsPerVertexStep;
  row.shareOfLimit = leastTime(*row.work, limits, isa, double(row.cells) * row.vertices) / time;
  const auto& peak = limits.arithmetic.at(isa);
  row.shareOfPeak = row.work->operations / peak.operations / time;
  row.shareWithRoots = *row.shareOfPeak + row.work->roots / peak.roots / time;
}

}  // namespace

BenchReport runBench(const BenchOptions& asked) {
  BenchOptions options = asked;
  BenchReport report;
  if (options.bullet && !bulletIsAvailable()) {
    options.bullet = false;
    report.remarks.push_back("Bullet is left out: this program was built without it");
  }
  if (options.bullet && options.singleBullet.empty())
    report.remarks.push_back("Bullet in single precision is left out: it is built with the tests, by ./morula test");
  LimitMeter meter(options.isas);
  for (const PlannedScene& scene : plan(options))
    for (BenchRow& row : measureScene(scene, options, meter)) report.rows.push_back(std::move(row));
  report.machine = meter.limits();
  for (BenchRow& row : report.rows) addShares(row, report.machine);
  report.ratios = findRatios(report.rows);
  return report;
}

const BenchRow* find(const std::vector<BenchRow>& rows, const std::string& scene, const std::string& engine,
                     Stage stage, int cells, int vertices, const std::string& isa, int threads, bool wallClock) {
  for (const BenchRow& row : rows)
    if (row.scene == scene && row.engine == engine && row.stage == stage && row.cells == cells &&
        row.vertices == vertices && row.isa == isa && row.threads == threads && row.wallClock == wallClock)
      return &row;
  return nullptr;
}

}  // namespace morula
