// morula bench: the costs of stages, beside the limits of the machine.
#include "bench/bench.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "cli/verbs.h"
#include "files/folders.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "pictures/pictures.h"
#include "store/machine_info.h"
#include "system/child_process.h"
#include "system/console.h"

namespace morula::cli {
namespace {

struct BenchWords {
  BenchOptions options{.levels = {}, .threads = {}};
  std::string out = "results", picture;
  bool quick = false, full = false, noBullet = false;
  OutputOptions output;
};

template <class T>
std::vector<T> sorted(std::vector<T> list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

/// Returns the level of the icosphere with so many vertices.
int readLevel(const std::string& text) {
  const auto vertices = natural(42, 642)(text);
  for (const unsigned level : {1u, 2u, 3u})
    if (vertices == 10 * (1u << 2 * level) + 2) return static_cast<int>(level);
  throw InputError(text + " is no icosphere's number; needs 42, 162 or 642");
}

/// Completes the options with defaults.
BenchOptions optionsOf(const BenchWords& words) {
  BenchOptions options = words.options;
  if (options.levels.empty() && !words.quick && options.cells.empty()) options.extraLevels = {1, 3};
  options.levels = options.levels.empty() ? std::vector{2} : sorted(options.levels);
  options.cells = sorted(options.cells);
  if (options.cells.empty()) {
    options.cells = {8, 16, 32, 64, 128, 256, 512};
    if (words.quick) options.cells = {8, 64};
    if (words.full) options.cells.insert(options.cells.end(), {1024, 2048, 4096});
  }
  options.isas = options.isas.empty() ? availableIsas() : sorted(options.isas);
  options.threads = options.threads.empty() ? std::vector{1, 2} : sorted(options.threads);
  if (options.threads.front() != 1) options.threads.insert(options.threads.begin(), 1);
  if (options.stages.empty())
    for (const auto stage : valuesOf<Stage>()) options.stages.push_back(stage);
  options.rounds = words.quick ? 3 : 5;
  options.stepsFactor = words.quick ? 0.34 : 1;
  options.bullet = !words.noBullet;
  options.folder = std::filesystem::path(words.out) / "bench";
  options.program = ownProgram();
  const std::filesystem::path single = std::filesystem::path(options.program).replace_filename("morula-single-bullet");
  if (fileExists(single)) options.singleBullet = single.string();
  options.tell = [quiet = words.output.quiet](const std::string& text) { tell("bench: " + text, quiet); };
  return options;
}

/// Writes the part of a row that Bullet has; null for other rows.
Json bulletJson(const BenchRow& row) {
  if (row.bulletSettings.empty()) return {};
  const auto one = [](const BulletSettingRow& s) {
    return Json{{"margin", s.margin}, {"iterations", s.iterations}, {"ns_per_vertex_step", s.nsPerVertexStep}};
  };
  Json all = Json::array();
  for (const auto& s : row.bulletSettings) all.push_back(one(s));
  return {{"best", one(row.bulletSettings.front())},
          {"lowest", row.bulletSettings.front().nsPerVertexStep},
          {"highest", row.bulletSettings.back().nsPerVertexStep},
          {"tried", all}};
}

/// Writes the least times per vertex and step by each part of the machine, and the part that binds; null without them.
Json limitJson(const BenchRow& row) {
  if (!row.limit) return {};
  Json json{{"bound", nameOf(row.limit->bound())}};
  for (const Bound bound : valuesOf<Bound>()) json[nameOf(bound)] = 1e9 * row.limit->of(bound);
  return json;
}

Json toJson(const BenchRow& row) {
  return {{"scene", row.scene},
          {"engine", nameOf(row.engine)},
          {"stage", nameOf(row.stage)},
          {"cells", row.cells},
          {"vertices", row.vertices},
          {"isa", row.isa.empty() ? Json() : Json(row.isa)},
          {"threads", row.threads},
          {"precision", nameOf(row.precision)},
          {"clock", row.wallClock ? "wall" : "cpu"},
          {"processors_free", orNull(row.processors)},
          {"search", row.search.empty() ? Json() : Json(row.search)},
          {"ns_per_vertex_step", row.nsPerVertexStep},
          {"spread", row.spread},
          {"limit", limitJson(row)},
          {"share_of_limit", orNull(row.shareOfLimit)},
          {"share_of_peak", orNull(row.shareOfPeak)},
          {"share_with_roots", orNull(row.shareWithRoots)},
          {"ns_per_vertex_once", orNull(row.nsPerVertexOnce)},
          {"pairs_per_vertex_step", orNull(row.pairsPerVertexStep)},
          {"slots_per_vertex_step", orNull(row.slotsPerVertexStep)},
          {"rebuilds_per_step", orNull(row.rebuildsPerStep)},
          {"choices_per_step", orNull(row.choicesPerStep)},
          {"bullet", bulletJson(row)}};
}

Json toJson(const MachineLimits& limits) {
  Json arithmetic = Json::array(), bandwidth = Json::array();
  for (const auto& [isa, a] : limits.arithmetic)
    arithmetic.push_back(
        {{"isa", name(isa)}, {"multiply_add_per_second", a.operations}, {"root_divide_per_second", a.roots},
         {"instructions_per_second", a.instructions}});
  for (const auto& [bytes, rate] : limits.bandwidth)
    bandwidth.push_back({{"bytes", bytes}, {"bytes_per_second", rate}});
  const auto machine = machineInfo();
  return {{"cpu", machine.cpu}, {"kernel", machine.kernel}, {"peak", arithmetic}, {"bandwidth", bandwidth}};
}

Json toJson(const BenchReport& report, const std::string& picture) {
  Json rows = Json::array(), ratios = Json::array(), thesis = Json::array();
  for (const auto& row : report.rows) rows.push_back(toJson(row));
  for (const auto& r : report.ratios)
    ratios.push_back({{"what", r.what},
                      {"value", r.value},
                      {r.atLeast ? "at_least" : "at_most", r.bound},
                      {"holds", r.notJudged.empty() ? Json(r.holds()) : Json()}});
  for (const auto& row : thesisTable) thesis.push_back({{"cells", row.cells}, {"ms_per_cell", row.msPerCell}});
  return {
      {"machine", toJson(report.machine)}, {"rows", rows}, {"thesis", thesis}, {"ratios", ratios}, {"picture", picture},
      {"remarks", report.remarks}};
}

int act(const BenchWords& words) {
  const auto options = optionsOf(words);
  const auto report = runBench(options);
  makeFolder(options.folder);
  const auto picture = words.picture.empty() ? (options.folder / "bench.png").string() : words.picture;
  writePicture(drawBench(report), picture);
  printEither(words.output, toJson(report, picture), textOf(describe(report)) + "\npicture  " + picture + "\n");
  return fine;
}

}  // namespace

void addBench(CLI::App& app, Action& action) {
  Verb verb(app, action, "bench", "Measure what each stage costs, beside the machine's limits and Bullet");
  auto& words = verb.does<BenchWords>(act);
  verb.takes("--cells", words.options.cells, "N,...", natural(1, 65536),
             "Numbers of cells of the packed scenes, as 64,128");
  verb.takes("--vertices", words.options.levels, "N,...", readLevel, "Vertices of each cell: 42, 162 or 642");
  verb.takes("--isa", words.options.isas, "NAME,...", parseIsa,
             "Measure only these instruction sets: scalar, narrow, avx2, avx512");
  verb.takes("--threads", words.options.threads, "N,...", natural(1, 1024), "Numbers of threads; default: 1,2");
  verb.takes("--stage", words.options.stages, "NAME,...", parseChoice<Stage>,
             "Measure only these stages: " + namesOf<Stage>());
  verb.takes("--quick", words.quick, "Measure few scenes in few rounds");
  verb.takes("--full", words.full, "Measure also scenes of up to 4096 cells");
  verb.oneOf({"--quick", "--full"});
  verb.takes("--no-bullet", words.noBullet, "Do not measure Bullet, which is slow");
  verb.takes("--out", words.out, "FOLDER", "Folder for results");
  verb.takes("-o,--output", words.picture, "FILE", pictureName("bench", true),
             "The chart, a .png, .svg or .pdf; default: bench.png in the folder");
  add(verb, words.output);
}

}  // namespace morula::cli
