#pragma once
// morula bench: what each stage costs, compared with what the machine could do, what Bullet takes and what the
// thesis took, all in one run.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/precision.h"
#include "bench/bullet_subject.h"
#include "bench/machine_limits.h"
#include "bench/work.h"
#include "charts/chart.h"
#include "document/document.h"

namespace morula {

enum class Stage { step, internal, contact, rebuild, integrate };
template <>
inline constexpr auto choices<Stage> = std::to_array<Choice<Stage>>({
    {Stage::step, "step", "a whole step"},
    {Stage::internal, "internal", "the forces of cells on themselves"},
    {Stage::contact, "contact", "the forces between cells"},
    {Stage::rebuild, "rebuild", "the search for neighbours"},
    {Stage::integrate, "integrate", "from forces to positions"},
});

struct BenchOptions {
  std::vector<int> cells = {};        // of packed scenes
  std::vector<int> levels{2};         // of the icosphere, for all of `cells`
  std::vector<int> extraLevels = {};  // for scenes of `extraCells` only
  int extraCells = 64;
  std::vector<Isa> isas = {};
  std::vector<int> threads{1};
  std::vector<Stage> stages = {};
  int rounds = 5;          // measurements of each thing, one after the other in turn
  double stepsFactor = 1;  // factor of the number of steps in a round; less: shorter rounds
  bool bullet = true;
  int maxBulletCells = 256;
  std::filesystem::path folder = {};  // where packed scenes are kept; "": nowhere
  std::string program = {};           // that answers to `engine-worker`
  std::string singleBullet = {};      // the same by Bullet in single precision; "": none was built
  std::function<void(const std::string&)> tell = [](const std::string&) {};
};

struct BenchRow {
  std::string scene;   // packed, packed-friction, packed-single, free
  std::string engine;  // morula, bullet-b1, bullet-b2, scalar
  Stage stage = Stage::step;
  int cells = 0, vertices = 0;
  std::string isa;
  Precision precision = Precision::binary64;
  int threads = 1;
  bool wallClock = false;                   // else CPU time
  std::optional<double> processors;         // that were free for a row on several threads
  std::string search;                       // of rows that search for neighbours
  double nsPerVertexStep = 0;               // median; by the wall's clock the shortest
  double spread = 0;                        // half the distance between quartiles, over the median
  std::optional<Work> work;                 // per vertex and step, where a limit is known
  std::optional<double> shareOfLimit;       // the least time that the machine would need, over this one
  std::optional<double> shareOfPeak;        // the same for multiplications and additions alone
  std::optional<double> shareWithRoots;     // the same with roots and their quotients after those
  std::optional<double> nsPerVertexSearch;  // rebuild: of one search, however often there is one
  // Counted, not measured: the same on every machine.
  std::optional<double> pairsPerVertexStep, rebuildsPerStep;
  // For rows of Bullet: all settings that were tried, the fastest first, which is the row's own.
  std::vector<BulletSettingRow> bulletSettings = {};
};

/// A bound that the project sets itself, of a ratio within one run.
struct BenchRatio {
  std::string what;
  double value = 0, bound = 0;
  bool atLeast = true;         // else at most
  std::string notJudged = {};  // why
  bool holds() const { return atLeast ? value >= bound : value <= bound; }
};

/// [Nilsson 2008, table 5.1]: one update on a PC of 2008, in Java.
struct ThesisRow {
  int cells;
  double msPerCell;
};
inline constexpr ThesisRow thesisTable[] = {{8, 1.75}, {16, 1.88}, {32, 1.94}, {64, 1.81}, {128, 1.88}, {256, 23.68}};

struct BenchReport {
  std::vector<BenchRow> rows;
  MachineLimits machine;
  std::vector<BenchRatio> ratios;
  std::vector<std::string> remarks;  // what was left out, and why
};

BenchReport runBench(const BenchOptions& options);

/// For people.
Document describe(const BenchReport& report);

/// Draws time per vertex and step over the number of cells, both on logarithmic scales. One line per
/// engine and instruction set, for whole steps of packed cells of 162 vertices; the thesis' own times, scaled
/// so that 8 cells cost as much as ours.
Drawing drawBench(const BenchReport& report);

/// The project's own bounds, read off a finished table: those whose rows are there.
std::vector<BenchRatio> findRatios(const std::vector<BenchRow>& rows);

/// The row of the packed scene that fits, or null.
const BenchRow* find(const std::vector<BenchRow>& rows, const std::string& scene, const std::string& engine,
                     Stage stage, int cells, int vertices, const std::string& isa, int threads = 1,
                     bool wallClock = false);

}  // namespace morula
