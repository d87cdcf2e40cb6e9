#pragma once
// morula bench: the cost of each stage, compared in one run with the machine's limits, Bullet and the thesis.
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
#include "engines/measured_engine.h"

namespace morula {

enum class Stage { step, internal, contact, rebuild, choice, integrate };
template <>
inline constexpr auto choices<Stage> = std::to_array<Choice<Stage>>({
    {Stage::step, "step", "a whole step"},
    {Stage::internal, "internal", "the forces of cells on themselves"},
    {Stage::contact, "contact", "the forces between cells"},
    {Stage::rebuild, "rebuild", "the search for neighbours"},
    {Stage::choice, "choice", "the choice of pairs that may act"},
    {Stage::integrate, "integrate", "from forces to positions"},
});

struct BenchOptions {
  std::vector<int> cells = {};        // numbers of cells of packed scenes
  std::vector<int> levels{2};         // levels of the icosphere, for all of `cells`
  std::vector<int> extraLevels = {};  // further levels, only for scenes of `extraCells`
  int extraCells = 64;
  std::vector<Isa> isas = {};
  std::vector<int> threads{1};
  std::vector<Stage> stages = {};
  int rounds = 5;          // number of measurements of each row, taken in turn
  double stepsFactor = 1;  // factor for the number of steps in a round
  bool bullet = true;
  int maxBulletCells = 256;
  std::filesystem::path folder = {};  // folder of stored packed scenes; "": none are stored
  std::string program = {};           // the program that answers to `internal engine-worker`
  std::string singleBullet = {};      // a program with Bullet in single precision; "": none was built
  std::function<void(const std::string&)> tell = [](const std::string&) {};
};

struct BenchRow {
  std::string scene;  // packed, packed-still, packed-viscosity, packed-single, free
  MeasuredEngine engine = MeasuredEngine::morula;
  Stage stage = Stage::step;
  int cells = 0, vertices = 0;
  std::string isa;
  Precision precision = Precision::binary64;
  int threads = 1;
  bool wallClock = false;                   // true: by wall clock time; false: by CPU time
  std::optional<double> processors;         // number of free processors for a row on several threads
  std::string search;                       // method of rows that search for neighbours
  double nsPerVertexStep = 0;               // the median; by wall clock time the shortest
  double spread = 0;                        // half the distance between quartiles, over the median
  std::optional<Work> work;                 // work per vertex and step, if a limit is known
  std::optional<WorkLimit> limit;
  std::optional<double> shareOfLimit;       // the longest of the limit's times, over the measured one
  std::optional<double> shareOfPeak;        // likewise for multiplications and additions alone
  std::optional<double> shareWithRoots;     // likewise with roots and their quotients after these
  std::optional<double> nsPerVertexOnce;    // for rebuild and choice: the time of one for all vertices
  // Counts, which are the same on every machine.
  std::optional<double> pairsPerVertexStep, slotsPerVertexStep;  // listed pairs; chosen ones, with slices' padding
  std::optional<double> rebuildsPerStep, choicesPerStep;
  // For rows of Bullet: all tried settings; the first is the fastest and gives the row's time.
  std::vector<BulletSettingRow> bulletSettings = {};
};

/// A bound that the project sets for a ratio within one run.
struct BenchRatio {
  std::string what;
  double value = 0, bound = 0;
  bool atLeast = true;         // true: `bound` is a min; false: a max
  std::string notJudged = {};  // the reason why the ratio is not judged
  bool holds() const { return atLeast ? value >= bound : value <= bound; }
};

/// A time of the thesis [Nilsson 2008, table 5.1]: one update on a PC of 2008, in Java.
struct ThesisRow {
  int cells;
  double msPerCell;
};
inline constexpr ThesisRow thesisTable[] = {{8, 1.75}, {16, 1.88}, {32, 1.94}, {64, 1.81}, {128, 1.88}, {256, 23.68}};

struct BenchReport {
  std::vector<BenchRow> rows;
  MachineLimits machine;
  std::vector<BenchRatio> ratios;
  std::vector<std::string> remarks;  // omitted measurements, with reasons
};

BenchReport runBench(const BenchOptions& options);

/// Describes a report for people.
Document describe(const BenchReport& report);

/// Draws time per vertex and step over the number of cells, both on logarithmic scales. A line for each engine and
/// instruction set shows whole steps of packed cells of 162 vertices. The thesis' times are scaled so that 8 cells cost
/// as much as Morula's.
Drawing drawBench(const BenchReport& report);

/// Returns the project's bounds on ratios whose rows are in the table.
std::vector<BenchRatio> findRatios(const std::vector<BenchRow>& rows);

/// Returns the row of the packed scene with these properties, or null.
const BenchRow* find(const std::vector<BenchRow>& rows, const std::string& scene, MeasuredEngine engine, Stage stage,
                     int cells, int vertices, const std::string& isa, int threads = 1, bool wallClock = false);

}  // namespace morula
