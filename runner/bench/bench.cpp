#include "bench/bench.h"

#include <fmt/format.h>

#include "bench/scene_bench.h"
#include "engines/bullet_scene.h"

namespace morula {

namespace {

struct Planned {
  PackedScene packed;
  std::string name;
  bool whole;
};

std::vector<Planned> plan(const BenchOptions& options) {
  std::vector<Planned> scenes;
  for (const int cells : options.cells)
    for (const int level : options.levels) {
      scenes.push_back({{.cells = cells, .level = level}, "packed", true});
      scenes.push_back({{.cells = cells, .level = level, .friction = 0.3}, "packed-friction", false});
      scenes.push_back(
          {{.cells = cells, .level = level, .precision = Precision::binary32}, "packed-single", false});
      scenes.push_back({{.cells = cells, .level = level, .contact = false}, "free", false});
    }
  for (const int level : options.extraLevels)
    scenes.push_back({{.cells = options.extraCells, .level = level}, "packed", true});
  return scenes;
}

/// A scene from packing to its last round; only one is in memory at a time.
void measure(const Planned& scene, const BenchOptions& options, LimitMeter& meter,
             std::vector<MeasuredRow>& rows) {
  SceneBench bench(options, scene.packed, scene.name, scene.whole);
  for (int i = 0; i < options.rounds; ++i) {
    options.tell(fmt::format("{} scene, {} cells, level {}: round {} of {}", scene.name, scene.packed.cells,
                             scene.packed.level, i + 1, options.rounds));
    meter.sample();
    bench.round();
  }
  for (MeasuredRow& row : bench.rows()) rows.push_back(std::move(row));
}

BenchRow withShares(const MeasuredRow& measured, const MachineLimits& limits) {
  BenchRow row = measured.row;
  if (!measured.work) return row;
  const Isa isa = parseIsa(row.isa);
  const double time = 1e-9 * row.nsPerVertexStep;
  row.shareOfLimit = leastTime(*measured.work, limits, isa, double(row.cells) * row.vertices) / time;
  const auto& peak = limits.arithmetic.at(isa);
  row.shareOfPeak = measured.work->operations / peak.operations / time;
  row.shareWithRoots = *row.shareOfPeak + measured.work->roots / peak.roots / time;
  return row;
}

}  // namespace

BenchReport runBench(const BenchOptions& asked) {
  BenchOptions options = asked;
  BenchReport report;
  if (options.bullet && !bulletIsAvailable()) {
    options.bullet = false;
    report.remarks.push_back("Bullet is left out: this program was built without it");
  }
  LimitMeter meter(options.isas);
  std::vector<MeasuredRow> measured;
  for (const Planned& scene : plan(options)) measure(scene, options, meter, measured);
  report.machine = meter.limits();
  for (const MeasuredRow& row : measured) report.rows.push_back(withShares(row, report.machine));
  report.ratios = findRatios(report.rows);
  return report;
}

const char* name(Stage stage) {
  switch (stage) {
    case Stage::step:
      return "step";
    case Stage::internal:
      return "internal";
    case Stage::contact:
      return "contact";
    case Stage::rebuild:
      return "rebuild";
    case Stage::integrate:
      return "integrate";
  }
  return "?";
}

const BenchRow* find(const std::vector<BenchRow>& rows, const std::string& scene, const std::string& engine,
                     Stage stage, int cells, int vertices, const std::string& isa, int threads,
                     bool wallClock) {
  for (const BenchRow& row : rows)
    if (row.scene == scene && row.engine == engine && row.stage == stage && row.cells == cells &&
        row.vertices == vertices && row.isa == isa && row.threads == threads && row.wallClock == wallClock)
      return &row;
  return nullptr;
}

}  // namespace morula
