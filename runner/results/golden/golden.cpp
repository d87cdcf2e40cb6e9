// The text of a golden file, written and read.
#include "golden/golden.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/hash.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/text.h"
#include "golden/item.h"
#include "golden/read_number.h"

namespace morula {
namespace {

std::string headerOf(int version) { return "morula golden " + std::to_string(version); }

/// Returns the digest of all that a run must reproduce. People may edit only reasons and tolerances.
std::string digestOf(const Golden& golden) {
  const GoldenData& data = golden.data;
  Hasher hasher;
  if (golden.version > 1) hasher.field("version").add(golden.version);
  hasher.field("scenario").add(data.scenario);
  hasher.field("scenario_hash").add(data.scenarioHash);
  hasher.field("seed").add(data.seed);
  for (const GoldenGrowth& g : golden.growth) hasher.add(g.size).add(g.step);
  for (const GoldenItem& item : golden.stated) hasher.add(write(item));
  for (const GoldenStatistic& statistic : golden.statistics) add(hasher, statistic);
  for (const auto& [key, value] : data.parameters) hasher.field("parameter").add(key).add(value);
  for (const GoldenItem& item : data.items) hasher.add(write(item));
  return hasher.digest().text();
}

/// The lines of a golden file, and the errors that any line can have.
class Lines {
 public:
  Lines(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  /// Takes the next line that is not blank; returns false at the end of the text.
  bool next(std::string_view& line) {
    while (begin_ < text_.size()) {
      ++number_;
      const std::size_t end = text_.find('\n', begin_);
      line = std::string_view(text_).substr(begin_, end - begin_);
      begin_ = end == std::string::npos ? text_.size() : end + 1;
      for (const std::string_view marker : {"<<<<<<<", "|||||||", "=======", ">>>>>>>"})
        if (line.starts_with(marker))
          fail("a merge marker; take one side's file whole, run the scenario and accept its result if it is right");
      if (end == std::string::npos) fail("the last line is cut short; the file is truncated, restore it from git");
      if (number_ == 1) ofOtherSystem_ = line.ends_with('\r');
      if (line.ends_with('\r') != ofOtherSystem_)
        fail(
            "some lines end in a carriage return and some do not; restore the file from git, and keep git from changing "
            "goldens by a line `*.golden -text` in .gitattributes");
      if (ofOtherSystem_) line.remove_suffix(1);
      if (!line.empty() && line.front() != '#') return true;
    }
    return false;
  }

  std::string place() const { return file_ + ':' + std::to_string(number_); }
  int number() const { return number_; }
  [[noreturn]] void fail(const std::string& what) const { throw InputError(place() + ": " + what); }

 private:
  const std::string& text_;
  const std::string& file_;
  std::size_t begin_ = 0;
  int number_ = 0;
  bool ofOtherSystem_ = false;  // all lines end in CR LF, as git writes them with core.autocrlf: the same text
};

/// Reads the next line, `keyword text`, and returns its text.
std::string header(Lines& lines, std::string_view keyword) {
  std::string_view line;
  if (!lines.next(line) || !line.starts_with(keyword) || line.size() < keyword.size() + 2 ||
      line[keyword.size()] != ' ')
    lines.fail(std::string(keyword) + " is expected here");
  return std::string(line.substr(keyword.size() + 1));
}

void checkEnd(const Lines& lines, std::string_view line, const Golden& golden) {
  const std::size_t items = golden.data.items.size();
  const std::size_t space = line.find(' ', 4);
  const std::optional<std::uint64_t> count = readNatural(line.substr(4, space - 4));
  if (!count || space == std::string_view::npos) lines.fail("`end ITEMS DIGEST` is expected");
  if (*count != items)
    lines.fail("the file has " + std::to_string(items) + " items, but " + std::to_string(*count) +
               " were accepted; restore it from git");
  if (line.substr(space + 1) != digestOf(golden))
    lines.fail(
        "the items above were edited after they had been accepted; restore the file from git, or accept the present "
        "result with `morula review SCENARIO --accept --why \"…\"`");
}

/// Reads a line of growth. Sizes must rise and steps must not fall, since another order gives another horizon.
GoldenGrowth readGrowth(const Lines& lines, std::string_view line, const std::vector<GoldenGrowth>& before) {
  takeWord(line);
  const auto size = readReal(takeWord(line));
  const auto step = readNatural(line);
  if (!size || !(*size > 0) || !step) lines.fail("`growth SIZE STEP` is expected");
  if (!(*size <= 1)) lines.fail("growth: the size " + exactText(*size) + " is above 1 radius of the egg");
  if (before.empty()) return {*size, *step};
  const GoldenGrowth& last = before.back();
  if (*size == last.size)
    lines.fail("growth: the size " + exactText(*size) + " stands twice; restore the file from git");
  if (*size < last.size)
    lines.fail("growth: the size " + exactText(*size) + " stands after " + exactText(last.size) +
               "; sizes rise from line to line: restore the file from git");
  if (*step < last.step)
    lines.fail("growth: " + exactText(*size) + " is reached at step " + std::to_string(*step) +
               ", before the smaller " + exactText(last.size) + " at step " + std::to_string(last.step) +
               "; restore the file from git");
  return {*size, *step};
}

std::pair<std::string, std::string> readParameter(const Lines& lines, std::string_view line) {
  takeWord(line);
  const std::string_view key = takeWord(line);
  if (key.empty() || line.empty()) lines.fail("`parameter KEY VALUE` is expected");
  return {std::string(key), std::string(line)};
}

/// Throws InputError if a growth is later than the run's last step.
void checkGrowth(const Lines& lines, const Golden& golden) {
  if (golden.growth.empty()) return;
  for (const auto* count : all<GoldenCount>(golden.data))
    if (count->name == "steps" && golden.growth.back().step > count->count)
      lines.fail("growth: step " + std::to_string(golden.growth.back().step) + " is after the run's last, " +
                 std::to_string(count->count) + "; restore the file from git");
}

/// Writes items with each kind under a heading, so that the file can be read without its description.
void addItems(const std::vector<GoldenItem>& items, std::string& text) {
  const GoldenItem* before = nullptr;
  for (const GoldenItem& item : items) {
    if (!before || before->index() != item.index()) text += '\n' + headingOf(item) + '\n';
    before = &item;
    text += write(item) + '\n';
  }
}

}  // namespace

std::string write(const GoldenStatistic& s) {
  const std::string interval = s.onePath ? "one-path" : "low " + exactText(s.low) + " high " + exactText(s.high);
  return "statistic " + s.measure + " against " + s.against + " difference " + exactText(s.difference) + ' ' +
         interval + " runs " + std::to_string(s.runs);
}

std::optional<GoldenStatistic> readStatistic(std::string_view line) {
  auto words = partsOf(line, ' ');
  if (line.ends_with(' ')) return std::nullopt;
  const bool onePath = words.size() == 9 && words[6] == "one-path";
  if (onePath) {
    words.erase(words.begin() + 6);
    words.insert(words.begin() + 6, {"low", words[5], "high", words[5]});
  }
  if (words.size() != 12) return std::nullopt;
  const char* const names[] = {"statistic", "against", "difference", "low", "high", "runs"};
  for (std::size_t i = 0; i < std::size(names); ++i)
    if (words[2 * i] != names[i]) return std::nullopt;
  const auto difference = readReal(words[5]), low = readReal(words[7]), high = readReal(words[9]);
  const auto runs = readNatural(words[11]);
  if (words[1].empty() || words[3].empty() || !difference || !low || !high || !(*low <= *high)) return std::nullopt;
  if (!runs || *runs < 2) return std::nullopt;
  return GoldenStatistic{words[1], words[3], *difference, *low, *high, *runs, onePath};
}

void add(Hasher& hasher, const GoldenStatistic& s) {
  hasher.field("statistic").add(s.measure).add(s.against).add(s.difference).add(s.low).add(s.high).add(s.runs);
  if (s.onePath) hasher.field("one-path");
}

std::optional<std::uint64_t> horizonOf(const Golden& golden, double size) {
  for (const GoldenGrowth& g : golden.growth)
    if (g.size >= size) return g.step;
  return std::nullopt;
}

double grownBy(const Golden& golden, std::uint64_t step) {
  double grown = 0;
  for (const GoldenGrowth& g : golden.growth)
    if (g.step <= step) grown = 10 * g.size;  // the next size has not been reached
  return grown;
}

std::string writeGolden(const Golden& golden) {
  const GoldenData& data = golden.data;
  std::string text = headerOf(golden.version);
  text += "\nscenario " + data.scenario + "\nseed " + std::to_string(data.seed) + "\nscenario_hash " +
          data.scenarioHash + "\naccepted_by " + golden.acceptedBy + "\nwhy " + golden.why + '\n';
  if (!golden.rules.empty()) text += '\n';
  for (const ToleranceRule& rule : golden.rules) text += rule.text() + '\n';
  if (!golden.growth.empty())
    text += "\n# growth size step: one unit in the last place, moved at the start, grows to so many radii\n";
  for (const GoldenGrowth& g : golden.growth)
    text += "growth " + exactText(g.size) + ' ' + std::to_string(g.step) + '\n';
  addItems(golden.stated, text);
  if (!golden.statistics.empty())
    text +=
        "\n# statistic measure: at the end, the mean under these settings less that under others, with its 95 % "
        "interval, by morula study compare\n";
  for (const GoldenStatistic& statistic : golden.statistics) text += write(statistic) + '\n';
  if (!data.parameters.empty()) text += "\n# parameter key value: what decides the result, defaults filled in\n";
  for (const auto& [key, value] : data.parameters) text += "parameter " + key + ' ' + value + '\n';
  addItems(data.items, text);
  return text + "\nend " + std::to_string(data.items.size()) + ' ' + digestOf(golden) + '\n';
}

Golden readGolden(const std::string& text, const std::string& file) {
  Golden golden;
  golden.file = file;
  GoldenData& data = golden.data;
  Lines lines(text, golden.file);
  std::string_view line;
  if (!lines.next(line)) throw InputError(file + ":1: the file is empty; restore it from git");
  for (golden.version = goldenVersion; golden.version > 0 && line != headerOf(golden.version);) --golden.version;
  if (golden.version == 0)
    lines.fail("the first line is not `" + headerOf(goldenVersion) + "`; this is no golden file of this version");
  data.scenario = header(lines, "scenario");
  const std::string seed = header(lines, "seed");
  if (const auto value = readNatural(seed)) data.seed = *value;
  else lines.fail("seed: '" + seed + "'; a whole number from 0 is expected");
  data.scenarioHash = header(lines, "scenario_hash");
  golden.acceptedBy = header(lines, "accepted_by");
  golden.why = header(lines, "why");

  std::map<std::string, int> seen;  // "kind key" → the line of the item
  const auto expectNew = [&](const std::string& name) {
    if (const auto [first, isNew] = seen.emplace(name, lines.number()); !isNew)
      lines.fail(name + " stands twice, first in line " + std::to_string(first->second) +
                 "; restore the file from git");
  };
  while (lines.next(line)) {
    if (line.starts_with("end ")) {
      checkGrowth(lines, golden);
      checkEnd(lines, line, golden);
      if (lines.next(line)) lines.fail("'" + std::string(line) + "' follows the end of the file; remove it");
      return golden;
    }
    if (line.starts_with("tolerance ")) {
      golden.rules.push_back(readRule(line, lines.place()));
      golden.rules.back().line = lines.number();
      continue;
    }
    if (line.starts_with("growth ")) {
      golden.growth.push_back(readGrowth(lines, line, golden.growth));
      continue;
    }
    if (line.starts_with("parameter ")) {
      data.parameters.push_back(readParameter(lines, line));
      expectNew("parameter " + data.parameters.back().first);
      continue;
    }
    if (line.starts_with("statistic ")) {
      const auto statistic = readStatistic(line);
      if (!statistic)
        lines.fail(
            "`statistic MEASURE against LABEL difference X low X high X runs N` is expected, low at most high, or "
            "`one-path` in place of `low X high X`");
      expectNew("statistic " + statistic->measure + " against " + statistic->against);
      golden.statistics.push_back(*statistic);
      continue;
    }
    if (line.starts_with("error time "))
      lines.fail(
          "this error has the form of an older version; accept the result again, and measure errors again with "
          "`morula accuracy`");
    GoldenItem item = readItem(line, lines.place());
    std::visit([&](auto& i) { i.line = lines.number(); }, item);
    expectNew(idOf(item));
    (checkOf(item) == "stated" ? golden.stated : data.items).push_back(std::move(item));
  }
  lines.fail("the file ends without its last line `end …`: it is truncated; restore it from git");
}

Golden readGoldenFile(const std::filesystem::path& file) {
  if (!fileExists(file))
    throw InputError(file.string() +
                     ": there is no golden file; look at the result and, if it is right, accept it with "
                     "`morula review SCENARIO --accept --why \"…\"`");
  return readGolden(readFile(file), file.string());
}

std::string acceptedBits(const Golden& golden) {
  const auto bits = all<GoldenBits>(golden.data);
  return bits.empty() ? "" : bits.front()->hash.text();
}

}  // namespace morula
