#include "options/options.h"

#include <tuple>

#include "base/error.h"
#include "files/text.h"
#include "pictures/pictures.h"
#include "system/console.h"
#include "system/usable_memory.h"
#include "values/value_types.h"

namespace morula::cli {

void add(Verb& verb, OutputOptions& options) {
  verb.takes("--json", options.json, "Print one JSON object on standard output");
  verb.takes("--quiet", options.quiet, "Print no remarks and no progress");
}

void add(Verb& verb, InputOptions& options) {
  verb.takes("--allow-outside", options.allowOutside,
             "Let the scenario name DNA and meshes outside of its folder; only for scenarios that you trust");
}

void add(Verb& verb, SceneOptions& options) {
  verb.takes("--set", options.set, "PATH=VALUE",
             "Change a parameter: --set physics.time_step=0.001; null removes it; may repeat");
  verb.takes("--seed", options.seed, "N", natural(0, scenario::largestNatural), "Seed that replaces the scenario's");
}

void add(Verb& verb, ExecutionOptions& options) {
  verb.takes("--threads", options.threads, "N", natural(1, 1024), "Number of threads; changes no result");
  verb.takes("--isa", options.isa, "NAME", parseIsa, "Compute with scalar, narrow, avx2 or avx512; changes no result");
  verb.takes("--search", options.search, "NAME", parseChoice<ContactSearch>,
             "Find contacts by " + namesOf<ContactSearch>() + "; changes no result");
  addMemoryLimit(verb, options);
}

void addMemoryLimit(Verb& verb, ExecutionOptions& options) {
  verb.takes("--memory-limit", options.memoryLimit, "SIZE", readSize,
             "Max memory of a run, as 8G; a run that needs more does not start or ends; default: nine tenths of the "
             "free memory");
}

void addRunChoice(Verb& verb, std::string& run) {
  verb.takes("--run", run, "ID", "Run of the database, by its id; default: the latest");
}

std::vector<Override> overrides(const SceneOptions& options) {
  std::vector<Override> list;
  for (const auto& text : options.set) list.push_back(parseOverride(text));
  if (options.seed) list.push_back({"seed", std::to_string(*options.seed), "--seed"});
  return list;
}

Execution execution(const ExecutionOptions& options) {
  Execution how;
  how.threads = options.threads.value_or(how.threads);
  how.memoryLimit = options.memoryLimit ? *options.memoryLimit : usableMemory();
  how.isa = options.isa.value_or(how.isa);
  how.search.method = options.search.value_or(how.search.method);
  return how;
}

void printEither(const OutputOptions& options, const Json& json, const std::string& text) {
  if (options.json) printJson(json);
  else print(text);
}

namespace {

/// Reads a number that `allowed` describes. Throws InputError.
template <class Number>
Number checked(const std::string& text, const scenario::Parsed<Number>& parsed, const std::string& allowed,
               bool holds) {
  if (!parsed.wrong.empty()) throw InputError("'" + text + "' " + parsed.wrong + "; needs " + allowed);
  if (!holds) throw InputError(text + " is out of range; needs " + allowed);
  return parsed.value;
}

}  // namespace

Reader<std::uint64_t> natural(std::uint64_t low, std::uint64_t high) {
  return [=](const std::string& text) {
    const auto number = scenario::parseNatural(text);
    return checked(text, number, "a whole number from " + std::to_string(low) + " to " + std::to_string(high),
                   number.value >= low && number.value <= high);
  };
}

Reader<double> number(const scenario::Range& range) {
  return [=](const std::string& text) {
    const auto number = scenario::parseReal(text);
    return checked(text, number, "a number " + range.text(), range.holds(number.value));
  };
}

double readSize(const std::string& text) {
  const auto size = scenario::parseSize(text);
  return checked(text, size, "a size > 0, as 500M or 8G (10⁶ or 10⁹ bytes)", size.value > 0);
}

namespace {

constexpr double leastMillimetres = 20, mostMillimetres = 1000;

/// Reads "85mm", "85mm×60mm", "1920x1080", or "900" for a square.
FigureSize readFigureSize(const std::string& text, std::uint64_t low, std::uint64_t high, bool onlyWidth) {
  std::string sides = text;
  if (const auto times = sides.find("×"); times != sides.npos) sides.replace(times, std::string("×").size(), "x");
  const auto x = sides.find('x');
  const bool inPrint = sides.ends_with("mm");
  const std::string allowed = onlyWidth
                                  ? "the width alone, as 85mm, or 20 to 1000 mm, or "
                                  : "85mm or 85mmx60mm, of 20 to 1000 mm, or WIDTHxHEIGHT, or N for a square, from ";
  const std::string needed = allowed + std::to_string(low) + " to " + std::to_string(high) + " pixels";
  const auto side = [&](std::string word) {
    if (!inPrint) {
      const auto number = scenario::parseNatural(word);
      return double(checked(word, number, needed, number.value >= low && number.value <= high));
    }
    if (word.ends_with("mm")) word.resize(word.size() - 2);
    const auto number = scenario::parseReal(word);
    return checked(word, number, needed, number.value >= leastMillimetres && number.value <= mostMillimetres);
  };
  if (onlyWidth && x != sides.npos) throw InputError("'" + text + "' has a height; needs " + needed);
  FigureSize size{.width = side(sides.substr(0, x)), .inPrint = inPrint};
  if (x != sides.npos) size.height = side(sides.substr(x + 1));
  else if (!inPrint) size.height = size.width;
  return size;
}

}  // namespace

FigureSize FigureOptions::both() const {
  FigureSize figure = size.value_or(FigureSize{});
  figure.font = font;
  return figure;
}

void addFigure(Verb& verb, FigureOptions& options, std::uint64_t low, std::uint64_t high, bool onlyWidth) {
  const auto readSize = [=](const std::string& text) { return readFigureSize(text, low, high, onlyWidth); };
  const auto readFont = [](std::string text) {
    if (text.ends_with("pt")) text.resize(text.size() - 2);
    const auto size = scenario::parseReal(text);
    return checked(text, size, "a size from 4 to 72 points, as 7pt", size.value >= 4 && size.value <= 72);
  };
  verb.takes("--size", options.size, onlyWidth ? "WIDTH" : "SIZE", readSize,
             onlyWidth ? "Width: 85mm in print, or 900 pixels; the height follows; default: what suits"
                       : "Width and height: 85mm or 85mmx60mm in print, or pixels: 900 or 1920x1080; default: what "
                         "suits");
  verb.takes("--font", options.font, "SIZE", readFont,
             "Size of ordinary text with --size, as 7pt; titles are larger by a seventh, numbers at axes smaller by "
             "one; default: 7pt in print, otherwise what suits");
  verb.onlyWith({"--font"}, {"--size"});
}

std::vector<std::uint64_t> readSeeds(const std::string& text) {
  const std::string allowed = "; needs FIRST..LAST, as 1..50";
  const auto dots = text.find("..");
  if (dots == text.npos) throw InputError("'" + text + "' is not a range" + allowed);
  const auto seed = natural(0, scenario::largestNatural);
  const auto first = seed(text.substr(0, dots)), last = seed(text.substr(dots + 2));
  if (last < first) throw InputError(text + " runs backward" + allowed);
  if (last - first >= 100'000) throw InputError(text + " are too many; at most 100000 at once");
  std::vector<std::uint64_t> seeds;
  for (auto seed = first; seed <= last; ++seed) seeds.push_back(seed);
  return seeds;
}

void checkPictureName(const std::string& verb, const std::string& file, bool drawing) {
  const auto format = pictureFormat(file);
  if (format && (drawing || *format == PictureFormat::png)) return;
  throw InputError(
      "'" + file + "' ends in " + std::filesystem::path(file).extension().string() + ", which " + verb +
      " cannot write; needs a name that ends in " +
      (drawing ? ".png, .svg or .pdf" : ".png, or of several pictures .mp4, .webm or .gif (shapes: morula export)"));
}

Reader<std::string> pictureName(const std::string& verb, bool drawing) {
  return [=](const std::string& file) { return checkPictureName(verb, file, drawing), file; };
}

std::string readPageName(const std::string& name) {
  if (const auto ending = std::filesystem::path(name).extension(); ending != ".html" && ending != ".htm")
    throw InputError("'" + name + "' does not end in .html, and a page is all that is written");
  return name;
}

Units readUnits(const std::string& text) {
  const std::string example = "needs a length and a time, as µm,min, or with factors, as 0.5µm,2min";
  const std::vector<std::string> parts = partsOf(text, ',');
  if (parts.size() != 2) throw InputError("'" + text + "' are no units; " + example);
  Units units;
  for (const auto& [part, name, factor] :
       {std::tuple(parts[0], &units.length, &units.perLength), {parts[1], &units.time, &units.perTime}}) {
    const std::size_t begin = std::min(part.find_first_not_of("0123456789."), part.size());
    if (begin > 0) *factor = number(scenario::Range{.low = 1e-30, .high = 1e30})(part.substr(0, begin));
    *name = part.substr(begin);
    if (!isCellName(*name)) throw InputError("'" + part + "' is no unit; " + example);
  }
  return units;
}

std::map<std::string, std::string> readColumns(const std::string& text) {
  std::map<std::string, std::string> columns;
  for (const std::string& part : partsOf(text, ',')) {
    const auto equals = part.find('=');
    if (equals == 0 || equals >= part.size() - 1)
      throw InputError("'" + part + "' names no column; needs the column and its header, as x=POSITION_X,y=POSITION_Y");
    columns[part.substr(0, equals)] = part.substr(equals + 1);
  }
  return columns;
}

}  // namespace morula::cli
