#pragma once
// Options that several verbs share, and readers of values.
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "drawing/figure_size.h"
#include "options/verb.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"
#include "system/json.h"
#include "values/units.h"
#include "yaml/numbers.h"

namespace morula::cli {

struct OutputOptions {
  bool json = false, quiet = false;
};

/// Access to files outside of the scenario's folder.
struct InputOptions {
  bool allowOutside = false;
};

/// Changes of the scene by --set and --seed.
struct SceneOptions {
  std::vector<std::string> set;
  std::optional<std::uint64_t> seed;
  bool empty() const { return set.empty() && !seed; }
};

/// Options of the computation, which change no result.
struct ExecutionOptions {
  std::optional<int> threads = 1;
  std::optional<Isa> isa = {};
  std::optional<ContactSearch> search = {};
  std::optional<double> memoryLimit = {};  // [byte]
};

void add(Verb& verb, OutputOptions& options);
void add(Verb& verb, InputOptions& options);
void add(Verb& verb, SceneOptions& options);
void add(Verb& verb, ExecutionOptions& options);
/// Adds `--memory-limit` alone, for verbs that make a world and do not run it.
void addMemoryLimit(Verb& verb, ExecutionOptions& options);
/// Adds `--run`: "Which run of the database; default: the latest".
void addRunChoice(Verb& verb, std::string& run);

std::vector<Override> overrides(const SceneOptions& options);
Execution execution(const ExecutionOptions& options);

/// Prints `json` or `text` to stdout, as --json asks.
void printEither(const OutputOptions& options, const Json& json, const std::string& text);

/// Reads a whole number in [low, high].
Reader<std::uint64_t> natural(std::uint64_t low, std::uint64_t high);
Reader<double> number(const scenario::Range& range);
/// [byte] Reads "500M", "8G", "1.5G", "200000000".
double readSize(const std::string& text);

/// The size of a figure and of its words, as all verbs take it that draw figures.
struct FigureOptions {
  std::optional<FigureSize> size;
  std::optional<double> font;  // [point]
  /// Returns both as one; without any what suits the figure.
  FigureSize both() const;
};
/// Adds --size and --font. Sides in pixels are in [low, high]. `onlyWidth`: the height follows from what is drawn.
void addFigure(Verb& verb, FigureOptions& options, std::uint64_t low, std::uint64_t high, bool onlyWidth = false);

/// Reads "1..50": the numbers from 1 to 50.
std::vector<std::uint64_t> readSeeds(const std::string& text);

/// Max size of a table of cells.
inline constexpr std::uint64_t maxTableBytes = std::uint64_t{1} << 30;
/// Reads the units of a table, "µm,min"; "0.5µm,2min": one length of the table is 0.5 µm, one time 2 min.
Units readUnits(const std::string& text);
/// Reads headers of a table by the names of its columns, "x=POSITION_X,name=CELL".
std::map<std::string, std::string> readColumns(const std::string& text);

/// Throws InputError unless the file's ending is one that `verb` writes: PNG, and for a `drawing` (a chart or a tree)
/// also SVG and PDF.
void checkPictureName(const std::string& verb, const std::string& file, bool drawing);

/// Reads a file's name that passes checkPictureName.
Reader<std::string> pictureName(const std::string& verb, bool drawing);

/// Reads the name of a page. Throws InputError unless the name ends in .html.
std::string readPageName(const std::string& name);

}  // namespace morula::cli
