// morula bench: what each stage costs, beside what the machine could do.
#include "bench/bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "base/error.h"
#include "cli/verbs.h"
#include "files/folders.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/picture_name.h"
#include "options/verb.h"
#include "pictures/pictures.h"
#include "store/machine_info.h"
#include "system/child_process.h"
#include "system/console.h"

namespace morula::cli {

namespace {

struct BenchWords {
  std::vector<std::string> cells, vertices, isas, threads, stages;
  std::string out = "results", picture;
  bool quick = false, full = false, noBullet = false;
  OutputOptions output;
};

constexpr Stage allStages[] = {Stage::step, Stage::internal, Stage::contact, Stage::rebuild,
                               Stage::integrate};

std::vector<int> numbers(const std::string& option, const std::vector<std::string>& words, int low,
                         int high) {
  std::vector<int> list;
  for (const auto& word : words)
    list.push_back(static_cast<int>(
        naturalOption(option, word, static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high))));
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

int levelOf(int vertices) {
  for (const int level : {1, 2, 3})
    if (vertices == 10 * (1 << 2 * level) + 2) return level;
  throw UsageError(fmt::format("--vertices: {} is no icosphere's number; needs 42, 162 or 642", vertices));
}

std::vector<Stage> stages(const std::vector<std::string>& words) {
  if (words.empty()) return {std::begin(allStages), std::end(allStages)};
  std::vector<Stage> list;
  for (const auto& word : words) {
    const auto* found = std::find_if(std::begin(allStages), std::end(allStages),
                                     [&](Stage stage) { return word == name(stage); });
    if (found == std::end(allStages))
      throw UsageError("--stage: '" + word +
                       "' is no stage; needs step, internal, contact, rebuild or integrate");
    list.push_back(*found);
  }
  return list;
}

std::vector<Isa> isas(const std::vector<std::string>& words) {
  std::vector<Isa> list;
  try {
    for (const auto& word : words) list.push_back(parseIsa(word));
  } catch (const InputError& error) { throw UsageError(std::string("--isa: ") + error.what()); }
  if (list.empty()) return availableIsas();
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

BenchOptions meant(const BenchWords& words) {
  if (words.quick && words.full) throw UsageError("--quick and --full: give one of them");
  BenchOptions options;
  options.cells = numbers("--cells", words.cells, 1, 65536);
  if (options.cells.empty()) {
    options.cells = {8, 16, 32, 64, 128, 256, 512};
    if (words.quick) options.cells = {8, 64};
    if (words.full) options.cells.insert(options.cells.end(), {1024, 2048, 4096});
  }
  if (!words.vertices.empty()) {
    options.levels.clear();
    for (const int vertices : numbers("--vertices", words.vertices, 42, 642))
      options.levels.push_back(levelOf(vertices));
  } else if (!words.quick && words.cells.empty()) {
    options.extraLevels = {1, 3};
  }
  options.isas = isas(words.isas);
  options.threads = words.threads.empty() ? std::vector{1, 2} : numbers("--threads", words.threads, 1, 1024);
  if (options.threads.front() != 1) options.threads.insert(options.threads.begin(), 1);
  options.stages = stages(words.stages);
  options.rounds = words.quick ? 3 : 5;
  options.stepsFactor = words.quick ? 0.34 : 1;
  options.bullet = !words.noBullet;
  options.folder = std::filesystem::path(words.out) / "bench";
  options.program = ownProgram();
  options.tell = [quiet = words.output.quiet](const std::string& text) { tell("bench: " + text, quiet); };
  return options;
}

/// Null of rows that are not Bullet's.
Json bulletJson(const BenchRow& row) {
  if (row.bulletSettings.empty()) return {};
  const auto one = [](const BulletSettingRow& s) {
    return Json{
        {"margin", s.margin}, {"iterations", s.iterations}, {"ns_per_vertex_step", s.nsPerVertexStep}};
  };
  Json all = Json::array();
  for (const auto& s : row.bulletSettings) all.push_back(one(s));
  return {{"best", one(row.bulletSettings.front())},
          {"lowest", row.bulletSettings.front().nsPerVertexStep},
          {"highest", row.bulletSettings.back().nsPerVertexStep},
          {"tried", all}};
}

Json toJson(const BenchRow& row) {
  return {{"scene", row.scene},
          {"engine", row.engine},
          {"stage", name(row.stage)},
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
          {"share_of_limit", orNull(row.shareOfLimit)},
          {"share_of_peak", orNull(row.shareOfPeak)},
          {"share_with_roots", orNull(row.shareWithRoots)},
          {"ns_per_vertex_search", orNull(row.nsPerVertexSearch)},
          {"pairs_per_vertex_step", orNull(row.pairsPerVertexStep)},
          {"rebuilds_per_step", orNull(row.rebuildsPerStep)},
          {"bullet", bulletJson(row)}};
}

Json toJson(const MachineLimits& limits) {
  Json arithmetic = Json::array(), bandwidth = Json::array();
  for (const auto& [isa, a] : limits.arithmetic)
    arithmetic.push_back(
        {{"isa", name(isa)}, {"multiply_add_per_second", a.operations}, {"root_divide_per_second", a.roots}});
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
  for (const auto& row : thesisTable)
    thesis.push_back({{"cells", row.cells}, {"ms_per_cell", row.msPerCell}});
  return {{"machine", toJson(report.machine)},
          {"rows", rows},
          {"thesis", thesis},
          {"ratios", ratios},
          {"picture", picture},
          {"remarks", report.remarks}};
}

int act(const BenchWords& words) {
  checkPictureName("bench", words.picture, true);
  const auto options = meant(words);
  const auto report = runBench(options);
  makeFolder(options.folder);
  const auto picture = words.picture.empty() ? (options.folder / "bench.png").string() : words.picture;
  writePicture(drawBench(report), picture);
  if (words.output.json) printJson(toJson(report, picture));
  else print(textOf(describe(report)) + "\npicture  " + picture + "\n");
  return fine;
}

}  // namespace

void addBench(CLI::App& app, Action& action) {
  auto words = std::make_shared<BenchWords>();
  Verb verb(app, action, "bench", "Measure what each stage costs, beside the machine's limits and Bullet");
  verb.takes("--cells", words->cells, "N,...", "Packed scenes of so many cells, as 64,128");
  verb.takes("--vertices", words->vertices, "N,...", "Of each cell: 42, 162, 642");
  verb.takes("--isa", words->isas, "NAME,...", "Only these of scalar, narrow, avx2 and avx512");
  verb.takes("--threads", words->threads, "N,...", "Numbers of threads; default 1,2");
  verb.takes("--stage", words->stages, "NAME,...",
             "Only these of step, internal, contact, rebuild and integrate");
  verb.takes("--quick", words->quick, "Few scenes, few rounds");
  verb.takes("--full", words->full, "Up to 4096 cells");
  verb.takes("--no-bullet", words->noBullet, "Without Bullet, which is slow");
  verb.takes("--out", words->out, "FOLDER", "Folder for results");
  verb.takes("-o,--output", words->picture, "FILE",
             "The chart, a .png, .svg or .pdf; default: bench.png in the folder");
  add(verb, words->output);
  verb.does([words] { return act(*words); });
}

}  // namespace morula::cli
